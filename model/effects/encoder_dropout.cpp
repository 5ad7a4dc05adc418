// encoder_dropout: counts are missing or frozen for a while.
#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

// Moves nothing: what it says of the counts is used where logs are read, and kept with the model.
class EncoderDropout final : public EffectOf<EncoderDropout> {
 public:
  explicit EncoderDropout(const EffectArguments&) {}
};

}  // namespace

EffectInfo encoder_dropout() {
  return {"encoder_dropout",
          "counts are missing or frozen for a while",
          "A loose cable or a dirty encoder: one wheel's counts stand still while it turns, or are absent. "
          "Found in "
          "the counts themselves; the rows are left out of every fit.",
          {{"", EffectStage::counts}},
          {{"share", "1", "of the time in which counts are missing", 0.0, 1.0, {}},
           {"duration", "s", "of one dropout, on average", 0.0, 1000.0, {}, 0.0, false}},
          {.encoders = true},
          [](const EffectArguments& arguments) { return std::make_unique<EncoderDropout>(arguments); }};
}

}  // namespace wheelwright::effects
