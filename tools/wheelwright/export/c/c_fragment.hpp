// How each effect is said in C99: the files of effects/, one per effect, which the build takes in as texts.
//
// A file NAME.c begins with a comment that says what is seen and, after "Inverse:", what the inverse does of
// it. It may define
//   NAME_state, NAME_reset(state, p, variant)                     if it has a memory
//   NAME_wheels([state,] p, variant, around, pair)                on commands or wheel speeds
//   NAME_body([state,] p, variant, around, twist)                 on the motion of the body
//   NAME_observed(p, pose)                                        on the point that a reference measures
//   NAME_rolling(p, variant)                                      as Effect::rolling
//   NAME_undo_wheels, NAME_undo_body (with a constant state)      the input that gives that output, or 0
// with `p` its parameters, and the variant's place in its EffectInfo. One without any of them says "Not
// said:" and why.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace wheelwright::tools {

struct CFragment {
  std::string_view name;
  std::string_view text;

  bool has(std::string_view function) const;
  // What follows `heading` in the first comment, in one line; empty where it is not there.
  std::string remark(std::string_view heading) const;
};

std::span<const CFragment> c_fragments();  // made by the build
std::string_view c_prelude();              // made by the build

// Null where the effect has no file.
const CFragment* find_c_fragment(std::string_view effect);

}  // namespace wheelwright::tools
