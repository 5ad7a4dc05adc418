// A type of messages as the steps that walk through one of its messages: which bytes are a number of which
// channel, and which are passed over. Made once for a stream, and run for each message.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "tools/wheelwright/import/formats/ros/messages/constant_text.hpp"
#include "tools/wheelwright/import/formats/ros/messages/definition.hpp"
#include "tools/wheelwright/import/formats/ros/messages/row_table.hpp"
#include "tools/wheelwright/import/formats/ros/messages/wire_cursor.hpp"

namespace wheelwright::import::ros {

// An array with more elements is passed over: an image, a scan, a path. With names beside it (JointState) it
// may have more.
inline constexpr std::uint32_t max_numbers_in_array = 16;
inline constexpr std::uint32_t max_messages_in_array = 8;
inline constexpr std::uint32_t max_named_elements = 64;

struct Step {
  enum class Code : std::uint8_t {
    number,         // one, to `channel`
    skip_numbers,   // one, or an array
    skip_strings,   // one, or an array
    skip_messages,  // an array
    text,           // to the text `slot`
    names,          // an array of strings, to the names `slot`
    numbers,        // an array, to the elements `slot`
    messages,       // an array, to the elements `slot`
  };
  Code code = Code::number;
  FieldKind kind = FieldKind::uint8;
  Arity arity = Arity::one;
  std::uint32_t count = 1;  // of a fixed array
  std::size_t channel = no_channel;
  std::size_t type = 0;  // of messages
  std::size_t slot = 0;
};

// What the elements of an array go to: channels of numbers, or programs of messages. They are made when the
// first message brings them.
struct Elements {
  std::string name;
  std::size_t names_slot = no_channel;  // of the array of strings that names them, where there is one
  std::vector<std::size_t> by_place;
  std::unordered_map<std::string, std::size_t> by_name;
  std::vector<std::string> last_names;  // messages mostly have the same names, in the same order
  std::vector<std::size_t> last;
};

struct Program {
  std::vector<Step> steps;
  std::vector<Elements> elements;
  std::vector<std::vector<std::string_view>> names;  // of the message at hand
};

// What a type takes on the wire, without alignment.
struct TypeSize {
  std::uint64_t min_bytes = 0;
  bool is_fixed = true;
};
std::size_t bytes_of(FieldKind kind);
std::size_t alignment_of(FieldKind kind);
std::vector<TypeSize> type_sizes(const MessageDefinition& definition);

// Makes programs of the types of a definition. Channels that they need are added to the table.
class ProgramCompiler {
 public:
  ProgramCompiler(const MessageDefinition& definition, RowTable& table, std::vector<ConstantText>& texts);

  // With names of frames as texts; null where the definition is too large.
  std::unique_ptr<Program> whole_message(std::size_t type);
  // An element of an array, its channels named "prefix.field"; null as above.
  std::unique_ptr<Program> element(std::size_t type, const std::string& prefix);
  // Passes over a message of a type; null as above.
  std::unique_ptr<Program> skipping(std::size_t type);

 private:
  enum class Use { skip, numbers, numbers_and_texts };
  std::unique_ptr<Program> compile(std::size_t type, const std::string& prefix, Use use);
  void add_type(Program& program, std::size_t type, const std::string& prefix, Use use);
  void add_field(Program& program, const Field& field, const std::string& path, Use use,
                 std::size_t names_slot);
  void add_array(Program& program, Step step, const std::string& path, std::size_t names_slot);

  const MessageDefinition& definition_;
  std::vector<TypeSize> sizes_;
  RowTable& table_;
  std::vector<ConstantText>& texts_;
  std::size_t steps_ = 0;
};

}  // namespace wheelwright::import::ros
