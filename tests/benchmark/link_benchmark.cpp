// The codec of the serial link: a reply or a stream frame from its first byte to a decoded reading.
#include <benchmark/benchmark.h>

#include <array>
#include <numeric>
#include <vector>

#include "drivers/open_interface/query_reader.hpp"
#include "drivers/open_interface/stream_reader.hpp"

namespace wheelwright::benchmarks {
namespace {

using namespace open_interface;

constexpr std::size_t replies = 64;  // the order of the packets alternates with a shorter cycle

void append_value(std::vector<std::uint8_t>& bytes, PacketId id) {
  const PacketInfo& packet = packet_info(id);
  const std::int32_t value = id == PacketId::voltage ? 15300 : 1;
  std::array<std::uint8_t, 2> encoded{};
  encode_value(packet, value, std::span(encoded).first(packet.bytes));
  bytes.insert(bytes.end(), encoded.begin(), encoded.begin() + packet.bytes);
}

void decode_reply(benchmark::State& state) {
  std::vector<std::vector<std::uint8_t>> bytes(replies);
  QueryReader twin;
  for (auto& reply : bytes) {
    for (const PacketId id : twin.begin()) append_value(reply, id);
  }
  QueryReader reader;
  std::size_t next = 0;
  for ([[maybe_unused]] const auto& iteration : state) {
    reader.begin();
    for (const std::uint8_t byte : bytes[next]) benchmark::DoNotOptimize(reader.take(byte));
    next = (next + 1) % replies;
  }
  if (reader.counts().sound != reader.counts().asked) state.SkipWithError("not every reply was sound");
}
BENCHMARK(decode_reply);

void decode_stream_frame(benchmark::State& state) {
  StreamReader reader;
  std::vector<std::uint8_t> frame{19, 0};
  for (const PacketId id : reader.packets()) {
    frame.push_back(static_cast<std::uint8_t>(id));
    append_value(frame, id);
  }
  frame[1] = static_cast<std::uint8_t>(frame.size() - 2);
  frame.push_back(static_cast<std::uint8_t>(-std::accumulate(frame.begin(), frame.end(), 0)));
  for ([[maybe_unused]] const auto& iteration : state) {
    for (const std::uint8_t byte : frame) benchmark::DoNotOptimize(reader.take(byte));
  }
  if (reader.counts().corrupt > 0) state.SkipWithError("not every frame was sound");
}
BENCHMARK(decode_stream_frame);

}  // namespace
}  // namespace wheelwright::benchmarks
