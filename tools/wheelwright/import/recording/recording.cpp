#include "tools/wheelwright/import/recording/recording.hpp"

#include <algorithm>

namespace wheelwright::import {

const Channel* Stream::find(std::string_view channel) const {
  const auto at = std::ranges::find(channels, channel, &Channel::name);
  return at == channels.end() ? nullptr : &*at;
}

const Stream* Recording::find(std::string_view stream) const {
  const auto at = std::ranges::find(streams, stream, &Stream::name);
  return at == streams.end() ? nullptr : &*at;
}

}  // namespace wheelwright::import
