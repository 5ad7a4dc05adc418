// Prints a recording as JSON, for tests in other languages: recording_json FILE
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tools/wheelwright/import/open_recording.hpp"

using namespace wheelwright;

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const auto recording = import::open_recording(argv[1]);
  if (!recording) {
    std::fprintf(stderr, "%s\n", recording.error().c_str());
    return 1;
  }
  nlohmann::json streams = nlohmann::json::object();
  for (const import::Stream& stream : recording->streams) {
    nlohmann::json channels = nlohmann::json::object();
    for (const import::Channel& channel : stream.channels) channels[channel.name] = channel.values;
    streams[stream.name] = {{"type", stream.type},
                            {"received_s", stream.received_s},
                            {"channels", std::move(channels)},
                            {"not_decoded", stream.not_decoded}};
  }
  const nlohmann::json text{
      {"format", recording->format}, {"remarks", recording->remarks}, {"streams", std::move(streams)}};
  std::puts(text.dump().c_str());
  return 0;
}
