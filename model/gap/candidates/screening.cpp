#include "model/gap/candidates/screening.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>

#include "model/gap/candidates/decoys.hpp"
#include "model/gap/candidates/screening_pairs.hpp"
#include "model/gap/candidates/screening_probes.hpp"
#include "model/statistics/dense_solve.hpp"

namespace wheelwright::gap {
namespace {

// An orthonormal basis of what the model's own parameters could take up.
Eigen::MatrixXd basis_of(const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd scaled = columns;
  for (Eigen::Index c = 0; c < scaled.cols(); ++c) {
    const double norm = scaled.col(c).norm();
    if (norm > 0.0) scaled.col(c) /= norm;
  }
  return orthonormal_basis(scaled);
}

// For effects with one size: the response need not be linear in it, so only some stretching is believed, and
// none beyond the next sizes that are tried themselves.
struct Segment {
  double least = 0.25;
  double most = 3.0;
};

Segment segment_of(const TrialEffect& effect) {
  Segment segment;
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
    const ParameterInfo& parameter = effect.parameter_info(i);
    if (!parameter.scales_effect || effect.parameters[i] == 0.0) continue;
    for (const double size : parameter.sizes) {
      const double ratio = size / effect.parameters[i];
      if (ratio > 0.0 && ratio < 1.0) segment.least = std::max(segment.least, ratio);
      if (ratio > 1.0) segment.most = std::min(segment.most, ratio);
    }
  }
  return segment;
}

// Whatever is below this of a change, rounding alone may be.
constexpr double min_share_left = 1e-10;

Common common_of(const Eigen::MatrixXd& changes, const Eigen::MatrixXd& basis, const Eigen::VectorXd& left) {
  const Eigen::MatrixXd taken_up = basis.transpose() * changes;
  Common common{changes.transpose() * changes, changes.transpose() * left};
  const Eigen::VectorXd whole = common.products.diagonal();
  common.products -= taken_up.transpose() * taken_up;
  for (Eigen::Index i = 0; i < whole.size(); ++i) {
    if (common.products(i, i) > min_share_left * whole(i)) continue;
    common.products.row(i).setZero();
    common.products.col(i).setZero();
    common.with_left(i) = 0.0;
  }
  return common;
}

Screened judged(const Probe& probe, const Common& common) {
  Screened result{{probe.info, probe.variant, probe.points[0]}, 0.0};
  if (!(common.products.diagonal().minCoeff() > 1e-12)) return result;  // invisible in these channels
  if (probe.points.size() > 1) {
    const Eigen::VectorXd amounts = solve_by_qr(common.products, -common.with_left);
    result.gain_nats = -0.5 * amounts.dot(common.with_left);
    std::size_t k = 0;
    for (std::size_t i = 0; i < result.start.parameters.size(); ++i) {
      const ParameterInfo& parameter = result.start.parameter_info(i);
      if (!parameter.scales_effect) continue;
      result.start.parameters[i] = std::clamp(amounts(static_cast<Eigen::Index>(k)) * parameter.sizes.front(),
                                              parameter.lower, parameter.upper);
      ++k;
    }
    return result;
  }
  const double power = common.products(0, 0);
  const auto [least, most] = segment_of(result.start);
  const double segment = std::clamp(-common.with_left(0) / power, least, most);
  result.gain_nats = -segment * (common.with_left(0) + 0.5 * segment * power);
  for (std::size_t i = 0; i < result.start.parameters.size(); ++i) {
    const ParameterInfo& parameter = result.start.parameter_info(i);
    if (!parameter.scales_effect || !vanishes_at_zero(parameter)) continue;
    result.start.parameters[i] =
        std::clamp(segment * result.start.parameters[i], parameter.lower, parameter.upper);
  }
  return result;
}

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// What the model's own parameters leave of the residuals, and a basis of what they could take up. Over all
// readings: what counts say of the wheels is not free to explain the motion.
struct Explained {
  Explained(const FitProblem& problem, const Fit& fit)
      : basis(basis_of(problem.jacobian(fit.model, fit.residuals))), residuals(vector_of(fit.residuals)) {
    left = residuals - basis * (basis.transpose() * residuals);
  }
  Eigen::MatrixXd basis;
  Eigen::VectorXd residuals;
  Eigen::VectorXd left;
};

// How effects change the residuals of the outputs that they affect, and how that correlates with what the fit
// leaves there.
class OutputResponses {
 public:
  OutputResponses(const FitProblem& problem, const Fit& fit, const Explained& explained, Outputs outputs)
      : problem_(problem), fit_(fit), outputs_(outputs), rows_(rows_of(problem, outputs)) {
    basis_ = explained.basis(rows_, Eigen::all);
    without_ = explained.residuals(rows_);
    left_ = explained.left(rows_);
  }

  Common common(std::span<const TrialEffect> effects, const ParallelFor& parallel_for) const {
    Eigen::MatrixXd changes(without_.size(), static_cast<Eigen::Index>(effects.size()));
    parallel_for(effects.size(),
                 [&](std::size_t i) { changes.col(static_cast<Eigen::Index>(i)) = change_by(effects[i]); });
    return common_of(changes, basis_, left_);
  }

 private:
  static std::vector<Eigen::Index> rows_of(const FitProblem& problem, Outputs outputs) {
    std::vector<Eigen::Index> rows;
    for (std::size_t i = 0; i < problem.readings(); ++i) {
      if (problem.is_among(i, outputs)) rows.push_back(static_cast<Eigen::Index>(i));
    }
    return rows;
  }

  Eigen::VectorXd change_by(const TrialEffect& effect) const {
    TrialModel with = fit_.model;
    with.effects.push_back(effect);
    return vector_of(problem_.residuals(with, outputs_))(rows_) - without_;
  }

  const FitProblem& problem_;
  const Fit& fit_;
  Outputs outputs_;
  std::vector<Eigen::Index> rows_;
  Eigen::MatrixXd basis_;
  Eigen::VectorXd without_;
  Eigen::VectorXd left_;
};

// Of effects of all outputs.
class Responses {
 public:
  Responses(const FitProblem& problem, const Fit& fit) : problem_(problem) {
    const Explained explained(problem, fit);
    for (const Outputs outputs : {Outputs::all, Outputs::wheels, Outputs::motion}) {
      if ((outputs == Outputs::all) == problem.outputs_are_tied())
        by_outputs_.emplace(outputs, OutputResponses(problem, fit, explained, outputs));
    }
  }

  Common common(std::span<const TrialEffect> effects, const ParallelFor& parallel_for) const {
    const auto count = static_cast<Eigen::Index>(effects.size());
    Common all{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count)};
    for (const auto& [outputs, responses] : by_outputs_) {
      std::vector<TrialEffect> own;
      std::vector<Eigen::Index> places;
      for (std::size_t i = 0; i < effects.size(); ++i) {
        if (problem_.outputs_of(effects[i]) != outputs) continue;
        own.push_back(effects[i]);
        places.push_back(static_cast<Eigen::Index>(i));
      }
      if (own.empty()) continue;
      const Common common = responses.common(own, parallel_for);
      all.products(places, places) = common.products;
      all.with_left(places) = common.with_left;
    }
    return all;
  }

 private:
  const FitProblem& problem_;
  std::map<Outputs, OutputResponses> by_outputs_;
};

struct Judgement {
  Screened screened;
  double nats = 0.0;  // that leaving it out would cost
};

// Some probes at a time: so many columns are multiplied by the basis at once.
void judge_some(std::span<const Probe> probes, const Responses& responses, std::span<Judgement> judgements) {
  std::vector<TrialEffect> effects;
  for (const Probe& probe : probes) {
    for (const auto& point : probe.points) effects.push_back({probe.info, probe.variant, point});
  }
  const Common common = responses.common(effects, serial_for);
  Eigen::Index first = 0;
  for (std::size_t p = 0; p < probes.size(); ++p) {
    const auto count = static_cast<Eigen::Index>(probes[p].points.size());
    const Common of_probe = common.of(first, count);
    judgements[p] = {judged(probes[p], of_probe), 0.5 * of_probe.products.sum()};
    first += count;
  }
}

std::vector<Judgement> judge_all(const std::vector<Probe>& probes, const Responses& responses,
                                 const ParallelFor& parallel_for) {
  constexpr std::size_t at_a_time = 8;
  std::vector<Judgement> judgements(probes.size());
  parallel_for((probes.size() + at_a_time - 1) / at_a_time, [&](std::size_t i) {
    const std::size_t first = i * at_a_time;
    const std::size_t count = std::min(at_a_time, probes.size() - first);
    judge_some(std::span(probes).subspan(first, count), responses,
               std::span(judgements).subspan(first, count));
  });
  return judgements;
}

// That of its wheels alike, where it has a size for each.
std::size_t alike_variant(const TrialEffect& effect) {
  return effect.info->variants[effect.variant].alike.value_or(effect.variant);
}

std::vector<Screened> best_of_each_variant(const std::vector<Judgement>& judgements) {
  std::vector<Screened> best;
  for (const Judgement& judgement : judgements) {
    const Screened& screened = judgement.screened;
    const auto same = std::ranges::find_if(best, [&](const Screened& other) {
      return other.start.info == screened.start.info &&
             alike_variant(other.start) == alike_variant(screened.start);
    });
    if (same == best.end()) {
      best.push_back(screened);
    } else if (screened.gain_nats > same->gain_nats) {
      *same = screened;
    }
  }
  std::ranges::sort(best, std::greater<>{}, &Screened::gain_nats);
  return best;
}

}  // namespace

Screening screen(const FitProblem& problem, const Fit& fit,
                 std::span<const EffectInfo* const> candidate_effects, const ParallelFor& parallel_for) {
  const std::vector<Probe> probes = probes_of(candidate_effects, problem, fit.model);
  const Responses responses(problem, fit);
  const std::vector<Judgement> judgements = judge_all(probes, responses, parallel_for);

  Screening result;
  for (std::size_t p = 0; p < probes.size(); ++p) {
    if (probes[p].info->variants[probes[p].variant].alike) continue;  // as visible as with both wheels alike
    result.visibility.push_back(
        {{probes[p].info, probes[p].variant, probes[p].points[0]}, judgements[p].nats});
  }
  result.best = best_of_each_variant(judgements);
  std::vector<Screened> named;
  std::vector<TrialEffect> effects;
  for (const auto& screened : result.best) {
    if (is_decoy(*screened.start.info)) continue;
    named.push_back(screened);
    effects.push_back(screened.start);
  }
  const Common common = responses.common(effects, parallel_for);
  result.pair = stronger_pair(named, common);
  return result;
}

}  // namespace wheelwright::gap
