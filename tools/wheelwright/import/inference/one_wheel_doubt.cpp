#include "tools/wheelwright/import/inference/one_wheel_doubt.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/missing_keys.hpp"
#include "tools/wheelwright/import/inference/unused_columns.hpp"

namespace wheelwright::import {

void doubt_one_wheel(std::span<const Recording> recordings, const GivenMapping& given, const Mapping& mapping,
                     std::vector<std::string>& doubts) {
  constexpr std::size_t enough_for_another = 2;
  if (!is_one_wheel(mapping) || given.says("wheels.left") || given.says("wheels.right")) return;
  const FoundChannel wheel = find_channel(recordings, mapping.wheels->left);
  if (wheel.channel == nullptr) return;
  std::string others;
  std::size_t count = 0;
  for (const Recording& recording : recordings) {
    for (const Stream& stream : recording.streams) {
      for (const Channel& channel : stream.channels) {
        const bool is_alike = &stream != wheel.stream && channel.name == wheel.channel->name;
        const bool is_beside = &stream == wheel.stream && !is_used(mapping, stream, channel) &&
                               std::isfinite(quantum(channel.values)) && !is_row_index(channel.values);
        if (!is_alike && !is_beside) continue;
        count += is_alike ? enough_for_another : 1;
        const std::string name =
            config::excerpt(stream.name.empty() ? channel.name : stream.name + ":" + channel.name);
        others += (others.empty() ? "'" : ", '") + name + "'";
      }
    }
  }
  if (count < enough_for_another) return;
  doubts.push_back("one wheel alone is read, '" + config::excerpt(mapping.wheels->left.text()) +
                   "', and not " + others +
                   "; if the robot has two: --set wheels.left=COLUMN --set wheels.right=COLUMN");
}

}  // namespace wheelwright::import
