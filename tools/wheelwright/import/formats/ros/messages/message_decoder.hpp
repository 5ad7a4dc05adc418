// Messages of one type, from their bytes to rows of a table. No type is known beforehand: the definition in
// the file says what the bytes are.
//
// Channels are the paths of numbers: "twist.linear.x". A time or duration is in seconds, a bool 0 or 1.
// Arrays of up to 16 numbers are "data[0]", "data[1]", ...; arrays of up to 8 messages "wheels[0].speed". In
// a message with an array of strings called name, names or ..._names, arrays that are as long are
// "position[left_wheel]". Longer arrays, covariances and strings have no channel.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "tools/wheelwright/import/formats/ros/messages/field_program.hpp"

namespace wheelwright::import::ros {

enum class Wire { ros1, cdr };

class MessageDecoder {
 public:
  // The table is to outlive the decoder. A failure says why no message of this definition can be decoded.
  static tl::expected<std::unique_ptr<MessageDecoder>, std::string> make(MessageDefinition definition,
                                                                         Wire wire, RowTable& table);

  // Fills the row of the table. What is wrong with a message is returned in one line; the row is clear then.
  std::optional<std::string> decode(std::string_view message);

  bool is_cdr() const { return wire_ == Wire::cdr; }

  // A message that is a list of transforms between frames (tf2_msgs/TFMessage) fills a row for each of them.
  bool is_transform_list() const { return transforms_.has_value(); }
  using TransformHandler = std::function<void(std::string_view parent, std::string_view child)>;
  std::optional<std::string> decode_transforms(std::string_view message, const TransformHandler& row_filled);

  // Names of frames, as far as messages had them.
  const std::vector<ConstantText>& texts() const { return texts_; }

 private:
  MessageDecoder(MessageDefinition definition, Wire wire, RowTable& table);
  std::optional<std::string> prepare();

  tl::expected<WireCursor, std::string> begin(std::string_view message) const;
  std::optional<std::string> fault(const WireCursor& cursor) const;
  void run(Program& program, WireCursor& cursor);
  void run_numbers(Program& program, const Step& step, WireCursor& cursor);
  void run_messages(Program& program, const Step& step, WireCursor& cursor);
  void skip_messages(std::size_t type, std::uint64_t count, WireCursor& cursor);
  void read_names(std::vector<std::string_view>& names, const Step& step, WireCursor& cursor);
  std::span<const std::size_t> members(Program& program, const Step& step, std::uint32_t count);
  std::size_t add_member(const std::string& name, const Step& step);

  MessageDefinition definition_;
  Wire wire_;
  RowTable& table_;
  std::vector<TypeSize> sizes_;
  std::vector<ConstantText> texts_;
  ProgramCompiler compiler_;
  std::unique_ptr<Program> program_;                // of a whole message, or of one transform
  std::optional<std::size_t> transforms_;           // the type of a transform
  std::vector<std::unique_ptr<Program>> elements_;  // of messages in arrays
  std::vector<std::unique_ptr<Program>> skipping_;  // of each type, when it is first needed
};

}  // namespace wheelwright::import::ros
