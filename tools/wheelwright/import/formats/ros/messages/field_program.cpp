#include "tools/wheelwright/import/formats/ros/messages/field_program.hpp"

#include <algorithm>

namespace wheelwright::import::ros {
namespace {

constexpr std::size_t max_steps = 100'000;  // of all programs of a stream
constexpr std::uint64_t huge_bytes = std::uint64_t{1} << 40U;
constexpr std::string_view filler_byte = "structure_needs_at_least_one_member";

class SizeTable {
 public:
  explicit SizeTable(const MessageDefinition& definition)
      : definition_(definition), sizes_(definition.types.size()), is_known_(definition.types.size()) {}

  std::vector<TypeSize> all() {
    for (std::size_t type = 0; type < sizes_.size(); ++type) of_type(type);
    return sizes_;
  }

 private:
  TypeSize of_type(std::size_t type) {
    if (is_known_[type]) return sizes_[type];
    TypeSize size;
    for (const Field& field : definition_.types[type].fields) {
      const TypeSize part = of_field(field);
      size.min_bytes = std::min(size.min_bytes + part.min_bytes, huge_bytes);
      size.is_fixed = size.is_fixed && part.is_fixed;
    }
    is_known_[type] = true;
    return sizes_[type] = size;
  }
  TypeSize of_field(const Field& field) {
    if (field.arity == Arity::sequence) return {4, false};
    TypeSize one{bytes_of(field.kind), is_number(field.kind)};
    if (field.kind == FieldKind::message) one = of_type(field.type);
    const std::uint64_t count = field.arity == Arity::fixed ? field.count : 1;
    const bool is_huge = one.min_bytes > 0 && count > huge_bytes / one.min_bytes;
    return {is_huge ? huge_bytes : count * one.min_bytes, one.is_fixed};
  }

  const MessageDefinition& definition_;
  std::vector<TypeSize> sizes_;
  std::vector<bool> is_known_;
};

// Covariances of a pose, a twist, a rotation; also the matrices of a camera.
bool is_matrix(const Field& field) {
  const bool is_real = field.kind == FieldKind::float32 || field.kind == FieldKind::float64;
  return field.name.find("covariance") != std::string::npos ||
         (is_real && field.arity == Arity::fixed && (field.count == 9 || field.count == 36));
}

bool names_its_neighbours(const Field& field) {
  return field.kind == FieldKind::string && field.arity != Arity::one &&
         (field.name == "name" || field.name == "names" || field.name.ends_with("_names"));
}

bool names_a_frame(const Field& field) {
  return field.kind == FieldKind::string && field.arity == Arity::one &&
         (field.name == "frame_id" || field.name == "child_frame_id");
}

}  // namespace

std::size_t bytes_of(FieldKind kind) {
  switch (kind) {
    case FieldKind::boolean:
    case FieldKind::int8:
    case FieldKind::uint8:
      return 1;
    case FieldKind::int16:
    case FieldKind::uint16:
      return 2;
    case FieldKind::int32:
    case FieldKind::uint32:
    case FieldKind::float32:
    case FieldKind::string:  // its length
    case FieldKind::wide_string:
      return 4;
    case FieldKind::int64:
    case FieldKind::uint64:
    case FieldKind::float64:
    case FieldKind::ros1_time:
    case FieldKind::ros1_duration:
    case FieldKind::ros2_time:
      return 8;
    case FieldKind::message:
      break;
  }
  return 0;
}

std::size_t alignment_of(FieldKind kind) {
  return kind == FieldKind::ros2_time ? 4 : bytes_of(kind);
}

std::vector<TypeSize> type_sizes(const MessageDefinition& definition) {
  return SizeTable(definition).all();
}

ProgramCompiler::ProgramCompiler(const MessageDefinition& definition, RowTable& table,
                                 std::vector<ConstantText>& texts)
    : definition_(definition), sizes_(type_sizes(definition)), table_(table), texts_(texts) {}

std::unique_ptr<Program> ProgramCompiler::whole_message(std::size_t type) {
  return compile(type, "", Use::numbers_and_texts);
}

std::unique_ptr<Program> ProgramCompiler::element(std::size_t type, const std::string& prefix) {
  return compile(type, prefix + ".", Use::numbers);
}

std::unique_ptr<Program> ProgramCompiler::skipping(std::size_t type) {
  return compile(type, "", Use::skip);
}

std::unique_ptr<Program> ProgramCompiler::compile(std::size_t type, const std::string& prefix, Use use) {
  auto program = std::make_unique<Program>();
  add_type(*program, type, prefix, use);
  table_.charge(program->steps.size() * sizeof(Step) / sizeof(double));
  return steps_ > max_steps ? nullptr : std::move(program);
}

void ProgramCompiler::add_type(Program& program, std::size_t type, const std::string& prefix, Use use) {
  std::size_t names_slot = no_channel;
  for (const Field& field : definition_.types[type].fields) {
    if (steps_ > max_steps) return;
    // What takes no bytes is left out, so that a message takes no more steps than it has bytes.
    if (field.arity == Arity::fixed && field.count == 0) continue;
    if (field.kind == FieldKind::message && field.arity != Arity::sequence &&
        sizes_[field.type].min_bytes == 0) {
      continue;
    }
    if (use != Use::skip && names_its_neighbours(field)) {
      names_slot = program.names.size();
      program.names.emplace_back();
      program.steps.push_back(
          {Step::Code::names, field.kind, field.arity, field.count, no_channel, 0, names_slot});
      ++steps_;
      continue;
    }
    add_field(program, field, prefix + field.name, use, names_slot);
  }
}

void ProgramCompiler::add_field(Program& program, const Field& field, const std::string& path, Use use,
                                std::size_t names_slot) {
  if (field.kind == FieldKind::message && field.arity == Arity::one)
    return add_type(program, field.type, path + ".", use);
  ++steps_;
  Step step{.kind = field.kind, .arity = field.arity, .count = field.count, .type = field.type};
  const bool is_kept = use != Use::skip && !is_matrix(field) && field.name != filler_byte;
  if (use == Use::numbers_and_texts && names_a_frame(field)) {
    step.code = Step::Code::text;
    step.slot = texts_.size();
    texts_.emplace_back(path);
  } else if (!is_number(field.kind) && field.kind != FieldKind::message) {
    step.code = Step::Code::skip_strings;
  } else if (is_kept && field.arity == Arity::one) {
    step.code = Step::Code::number;
    step.channel = table_.add_channel(path);
  } else if (is_kept) {
    return add_array(program, step, path, names_slot);
  } else {
    step.code = is_number(field.kind) ? Step::Code::skip_numbers : Step::Code::skip_messages;
  }
  program.steps.push_back(step);
}

void ProgramCompiler::add_array(Program& program, Step step, const std::string& path,
                                std::size_t names_slot) {
  step.code = is_number(step.kind) ? Step::Code::numbers : Step::Code::messages;
  step.slot = program.elements.size();
  Elements elements;
  elements.name = path;
  elements.names_slot = names_slot;
  program.elements.push_back(std::move(elements));
  program.steps.push_back(step);
}

}  // namespace wheelwright::import::ros
