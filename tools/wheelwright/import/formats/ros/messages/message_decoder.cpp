#include "tools/wheelwright/import/formats/ros/messages/message_decoder.hpp"

#include <algorithm>
#include <utility>

namespace wheelwright::import::ros {
namespace {

using Failure = tl::unexpected<std::string>;

constexpr std::size_t longest_element_name = 200;
constexpr std::size_t max_padding_bytes = 7;  // behind a message of CDR
constexpr std::string_view too_large =
    "its definition is too large: more than 100 000 fields with those of its parts";

double read_number(WireCursor& cursor, FieldKind kind) {
  constexpr double nanosecond = 1e-9;
  const auto real = [](auto value) { return static_cast<double>(value); };
  switch (kind) {
    case FieldKind::boolean:
      return cursor.number<std::uint8_t>() != 0 ? 1.0 : 0.0;
    case FieldKind::int8:
      return real(cursor.number<std::int8_t>());
    case FieldKind::uint8:
      return real(cursor.number<std::uint8_t>());
    case FieldKind::int16:
      return real(cursor.number<std::int16_t>());
    case FieldKind::uint16:
      return real(cursor.number<std::uint16_t>());
    case FieldKind::int32:
      return real(cursor.number<std::int32_t>());
    case FieldKind::uint32:
      return real(cursor.number<std::uint32_t>());
    case FieldKind::int64:
      return real(cursor.number<std::int64_t>());
    case FieldKind::uint64:
      return real(cursor.number<std::uint64_t>());
    case FieldKind::float32:
      return real(cursor.number<float>());
    case FieldKind::float64:
      return cursor.number<double>();
    case FieldKind::ros1_time: {
      const double seconds = real(cursor.number<std::uint32_t>());
      return seconds + nanosecond * real(cursor.number<std::uint32_t>());
    }
    case FieldKind::ros1_duration: {
      const double seconds = real(cursor.number<std::int32_t>());
      return seconds + nanosecond * real(cursor.number<std::int32_t>());
    }
    case FieldKind::ros2_time: {
      const double seconds = real(cursor.number<std::int32_t>());
      return seconds + nanosecond * real(cursor.number<std::uint32_t>());
    }
    case FieldKind::string:
    case FieldKind::wide_string:
    case FieldKind::message:
      break;
  }
  return 0.0;
}

std::uint32_t count_of(const Step& step, WireCursor& cursor) {
  return step.arity == Arity::sequence ? cursor.count() : step.count;
}

bool has_field(const MessageType& type, std::string_view name, FieldKind kind) {
  return std::ranges::any_of(type.fields, [&](const Field& field) {
    return field.name == name && field.kind == kind && field.arity == Arity::one;
  });
}

std::optional<std::size_t> transform_type(const MessageDefinition& definition) {
  const std::vector<Field>& fields = definition.types.front().fields;
  if (fields.size() != 1 || fields[0].kind != FieldKind::message || fields[0].arity != Arity::sequence)
    return std::nullopt;
  const MessageType& element = definition.types[fields[0].type];
  const bool is_transform = has_field(element, "header", FieldKind::message) &&
                            has_field(element, "child_frame_id", FieldKind::string) &&
                            has_field(element, "transform", FieldKind::message);
  return is_transform ? std::optional(fields[0].type) : std::nullopt;
}

bool has_wide_strings(const MessageDefinition& definition) {
  return std::ranges::any_of(definition.types, [](const MessageType& type) {
    return std::ranges::find(type.fields, FieldKind::wide_string, &Field::kind) != type.fields.end();
  });
}

// The encapsulation of CDR: a byte that is zero, one for the encoding, two of options.
tl::expected<WireFormat, std::string> format_of(std::string_view header) {
  WireFormat format{8, false, true};
  switch (static_cast<unsigned char>(header[1])) {
    case 0x00:
      format.is_swapped = true;
      break;
    case 0x01:
      break;
    case 0x06:
    case 0x10:
      format = {4, true, true};
      break;
    case 0x07:
    case 0x11:
      format = {4, false, true};
      break;
    default:
      return Failure("is CDR with parameter lists or delimiters, which is not read; plain CDR would be");
  }
  if (header[0] != 0) return Failure("does not begin with the header of CDR");
  return format;
}

}  // namespace

tl::expected<std::unique_ptr<MessageDecoder>, std::string> MessageDecoder::make(MessageDefinition definition,
                                                                                Wire wire, RowTable& table) {
  std::unique_ptr<MessageDecoder> decoder(new MessageDecoder(std::move(definition), wire, table));
  if (auto why = decoder->prepare()) return Failure(*std::move(why));
  return decoder;
}

MessageDecoder::MessageDecoder(MessageDefinition definition, Wire wire, RowTable& table)
    : definition_(std::move(definition)),
      wire_(wire),
      table_(table),
      sizes_(type_sizes(definition_)),
      compiler_(definition_, table_, texts_),
      transforms_(transform_type(definition_)),
      skipping_(definition_.types.size()) {}

std::optional<std::string> MessageDecoder::prepare() {
  // Middlewares write its characters with 2 or with 4 bytes, and do not say which.
  if (has_wide_strings(definition_)) return "its definition has a wstring, which is not read";
  program_ = compiler_.whole_message(transforms_.value_or(0));
  return program_ ? std::nullopt : std::optional(std::string(too_large));
}

std::optional<std::string> MessageDecoder::decode(std::string_view message) {
  auto cursor = begin(message);
  if (!cursor) return cursor.error();
  run(*program_, *cursor);
  auto why = fault(*cursor);
  if (why) table_.clear_row();
  return why;
}

std::optional<std::string> MessageDecoder::decode_transforms(std::string_view message,
                                                             const TransformHandler& row_filled) {
  auto check = begin(message);
  if (!check) return check.error();
  WireCursor cursor = *check;
  skip_messages(*transforms_, check->count(), *check);
  if (auto why = fault(*check)) return why;

  const std::uint32_t count = cursor.count();
  for (std::uint32_t i = 0; i < count; ++i) {
    run(*program_, cursor);
    std::string_view parent;
    std::string_view child;
    for (const ConstantText& text : texts_) {
      if (text.name == "child_frame_id") child = text.last;
      if (text.name == "header.frame_id") parent = text.last;
    }
    row_filled(parent, child);
  }
  return std::nullopt;
}

tl::expected<WireCursor, std::string> MessageDecoder::begin(std::string_view message) const {
  if (wire_ == Wire::ros1) return WireCursor(message, WireFormat{});
  constexpr std::size_t header_bytes = 4;
  if (message.size() < header_bytes) return Failure("is too short for the header of CDR");
  const auto format = format_of(message.substr(0, header_bytes));
  if (!format) return Failure(format.error());
  return WireCursor(message.substr(header_bytes), *format);
}

std::optional<std::string> MessageDecoder::fault(const WireCursor& cursor) const {
  if (cursor.has_failed()) return "is shorter than its definition says";
  if (cursor.left() <= (wire_ == Wire::cdr ? max_padding_bytes : 0)) return std::nullopt;
  return "has " + std::to_string(cursor.left()) + " bytes more than its definition says";
}

void MessageDecoder::run(Program& program, WireCursor& cursor) {
  for (const Step& step : program.steps) {
    switch (step.code) {
      case Step::Code::number:
        table_.set(step.channel, read_number(cursor, step.kind));
        break;
      case Step::Code::skip_numbers:
        cursor.skip(count_of(step, cursor), bytes_of(step.kind), alignment_of(step.kind));
        break;
      case Step::Code::skip_strings:
        for (std::uint32_t left = count_of(step, cursor); left > 0 && !cursor.has_failed(); --left)
          cursor.text();
        break;
      case Step::Code::skip_messages:
        skip_messages(step.type, count_of(step, cursor), cursor);
        break;
      case Step::Code::text:
        texts_[step.slot].see(cursor.text());
        break;
      case Step::Code::names:
        read_names(program.names[step.slot], step, cursor);
        break;
      case Step::Code::numbers:
        run_numbers(program, step, cursor);
        break;
      case Step::Code::messages:
        run_messages(program, step, cursor);
        break;
    }
  }
}

void MessageDecoder::run_numbers(Program& program, const Step& step, WireCursor& cursor) {
  const std::uint32_t count = count_of(step, cursor);
  const std::size_t bytes = bytes_of(step.kind);
  if (count > cursor.left() / bytes) return cursor.fail();
  const auto channels = members(program, step, count);
  if (channels.empty()) return cursor.skip(count, bytes, alignment_of(step.kind));
  for (const std::size_t channel : channels) table_.set(channel, read_number(cursor, step.kind));
}

void MessageDecoder::run_messages(Program& program, const Step& step, WireCursor& cursor) {
  const std::uint32_t count = count_of(step, cursor);
  const std::uint64_t min_bytes = sizes_[step.type].min_bytes;
  if (min_bytes == 0) return;
  if (count > cursor.left() / min_bytes) return cursor.fail();
  const auto programs = members(program, step, count);
  if (programs.empty()) return skip_messages(step.type, count, cursor);
  for (const std::size_t at : programs) {
    if (at == no_channel) {
      skip_messages(step.type, 1, cursor);
    } else {
      run(*elements_[at], cursor);
    }
  }
}

void MessageDecoder::skip_messages(std::size_t type, std::uint64_t count, WireCursor& cursor) {
  const TypeSize size = sizes_[type];
  if (size.min_bytes == 0 || count == 0) return;
  if (count > cursor.left() / size.min_bytes) return cursor.fail();
  if (size.is_fixed && wire_ == Wire::ros1) return cursor.skip(count, size.min_bytes, 1);
  if (!skipping_[type]) skipping_[type] = compiler_.skipping(type);
  if (!skipping_[type]) return cursor.fail();
  for (; count > 0 && !cursor.has_failed(); --count) run(*skipping_[type], cursor);
}

void MessageDecoder::read_names(std::vector<std::string_view>& names, const Step& step, WireCursor& cursor) {
  names.clear();
  for (std::uint32_t left = count_of(step, cursor); left > 0 && !cursor.has_failed(); --left) {
    const std::string_view name = cursor.text().substr(0, longest_element_name);
    if (names.size() <= max_named_elements) names.push_back(name);  // one more: then they are too many
  }
}

// Where each of `count` elements goes; empty where they are too many to be kept.
std::span<const std::size_t> MessageDecoder::members(Program& program, const Step& step,
                                                     std::uint32_t count) {
  Elements& elements = program.elements[step.slot];
  const bool has_names = elements.names_slot != no_channel;
  const auto names = has_names ? std::span<const std::string_view>(program.names[elements.names_slot])
                               : std::span<const std::string_view>();
  if (count == 0) return {};
  if (names.size() != count || count > max_named_elements) {
    if (count > (is_number(step.kind) ? max_numbers_in_array : max_messages_in_array)) return {};
    while (elements.by_place.size() < count) {
      const std::string place = std::to_string(elements.by_place.size());
      elements.by_place.push_back(add_member(elements.name + "[" + place + "]", step));
    }
    return std::span(elements.by_place).first(count);
  }
  if (std::ranges::equal(names, elements.last_names)) return elements.last;
  elements.last_names.assign(names.begin(), names.end());
  elements.last.clear();
  for (const std::string& name : elements.last_names) {
    const auto known = elements.by_name.find(name);
    if (known != elements.by_name.end()) {
      elements.last.push_back(known->second);
      continue;
    }
    elements.last.push_back(add_member(elements.name + "[" + name + "]", step));
    if (elements.last.back() != no_channel) elements.by_name.emplace(name, elements.last.back());
  }
  return elements.last;
}

// A channel, or the place of a program; no_channel where there is room for no more.
std::size_t MessageDecoder::add_member(const std::string& name, const Step& step) {
  if (is_number(step.kind)) return table_.add_channel(name);
  if (table_.channels() >= max_channels) return no_channel;
  auto program = compiler_.element(step.type, name);
  if (!program) return no_channel;
  elements_.push_back(std::move(program));
  return elements_.size() - 1;
}

}  // namespace wheelwright::import::ros
