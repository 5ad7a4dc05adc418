#include "model/gap/screening.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "model/gap/decoys.hpp"

namespace wheelwright::gap {
namespace {

// Several parameters of an effect act together, in proportion (sine and cosine, x and y): they are looked at
// at once.
struct Probe {
  const EffectInfo* info;
  std::size_t variant;
  std::vector<std::vector<double>> points;  // parameter vectors; more than one for effects of several sizes
};

struct Grid {
  std::vector<double> x;
  std::vector<double> y;
};

// Places where the robot has been.
std::vector<Pose> visited_places(const GapProblem& problem, const TrialModel& model) {
  constexpr double apart_m = 0.35;
  constexpr std::size_t most = 40;
  std::vector<Pose> places;
  for (const auto& run : problem.runs()) {
    const auto states = model_states(model, run);
    const std::size_t step = std::max<std::size_t>(1, states.size() / 200);
    for (std::size_t k = 0; k < states.size(); k += step) {
      Pose at = states[k].pose;
      // Where the robot really was is known better than where the model thinks.
      for (const auto& reference : run.references) {
        if (reference.at.period >= k) {
          at = reference.pose;
          break;
        }
      }
      const auto near = [&](const Pose& other) { return distance_between_m(at, other) < apart_m; };
      if (places.size() < most && std::ranges::none_of(places, near)) places.push_back(at);
    }
  }
  return places;
}

// Without counts nothing tells whether the wheels or the floor lose the motion: one of the two is enough.
bool told_apart(const EffectInfo& info, std::size_t variant, bool counts) {
  return counts || !info.variants[variant].name.ends_with("at_wheels");
}

void add_probes(const EffectInfo& info, const std::vector<Pose>& places, bool counts,
                std::vector<Probe>& probes) {
  std::vector<std::size_t> sizes;
  std::vector<std::size_t> shapes;
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    (info.parameters[i].scales_effect ? sizes : shapes).push_back(i);
  }
  std::vector<std::vector<double>> shape_points{std::vector<double>(info.parameters.size(), 0.0)};
  const bool placed = info.name == "surface_patch";
  for (const std::size_t shape : shapes) {
    std::vector<std::vector<double>> more;
    if (placed && info.parameters[shape].name == "x") {
      for (const auto& point : shape_points) {
        for (const Pose& place : places) {
          more.push_back(point);
          more.back()[shape] = place.x_m;
          more.back()[shape + 1] = place.y_m;
        }
      }
    } else if (placed && info.parameters[shape].name == "y") {
      continue;
    } else {
      for (const auto& point : shape_points) {
        for (const double value : info.parameters[shape].sizes) {
          more.push_back(point);
          more.back()[shape] = value;
        }
      }
    }
    shape_points = std::move(more);
  }
  for (std::size_t variant = 0; variant < info.variants.size(); ++variant) {
    if (!told_apart(info, variant, counts)) continue;
    for (const auto& shape : shape_points) {
      if (sizes.size() == 1) {
        for (const double value : info.parameters[sizes[0]].sizes) {
          Probe probe{&info, variant, {shape}};
          probe.points[0][sizes[0]] = value;
          probes.push_back(std::move(probe));
        }
      } else if (sizes.size() > 1) {
        Probe probe{&info, variant, {}};
        for (const std::size_t size : sizes) {
          probe.points.push_back(shape);
          probe.points.back()[size] = info.parameters[size].sizes.front();
        }
        probes.push_back(std::move(probe));
      }
    }
  }
}

// An orthonormal basis of what the model's own parameters could take up.
Eigen::MatrixXd basis_of(const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd scaled = columns;
  for (Eigen::Index c = 0; c < scaled.cols(); ++c) {
    const double norm = scaled.col(c).norm();
    if (norm > 0.0) scaled.col(c) /= norm;
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled);
  return qr.householderQ() * Eigen::MatrixXd::Identity(scaled.rows(), qr.rank());
}

// For effects with one size: the response need not be linear in it, so only some stretching is believed, and
// none beyond the next sizes that are tried themselves.
struct Stretch {
  double least = 0.25;
  double most = 3.0;
};

Stretch stretch_of(const EffectInfo& info, const std::vector<double>& point) {
  Stretch stretch;
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    if (!info.parameters[i].scales_effect || point[i] == 0.0) continue;
    for (const double size : info.parameters[i].sizes) {
      const double ratio = size / point[i];
      if (ratio > 0.0 && ratio < 1.0) stretch.least = std::max(stretch.least, ratio);
      if (ratio > 1.0) stretch.most = std::min(stretch.most, ratio);
    }
  }
  return stretch;
}

bool vanishes_at_zero(const ParameterInfo& parameter) {
  return parameter.lower <= 0.0 && parameter.upper >= 0.0;
}

Screened judged(const Probe& probe, const Eigen::MatrixXd& changes, const Eigen::VectorXd& left) {
  Screened result{{probe.info, probe.variant, probe.points[0]}, 0.0};
  if (!(changes.colwise().squaredNorm().minCoeff() > 1e-12)) return result;  // invisible in these channels
  if (probe.points.size() > 1) {
    const Eigen::VectorXd amounts = changes.colPivHouseholderQr().solve(-left);
    result.gain_nats = 0.5 * (left.squaredNorm() - (left + changes * amounts).squaredNorm());
    std::size_t k = 0;
    for (std::size_t i = 0; i < probe.info->parameters.size(); ++i) {
      const ParameterInfo& parameter = probe.info->parameters[i];
      if (!parameter.scales_effect) continue;
      result.start.parameters[i] = std::clamp(amounts(static_cast<Eigen::Index>(k)) * parameter.sizes.front(),
                                              parameter.lower, parameter.upper);
      ++k;
    }
    return result;
  }
  const double power = changes.col(0).squaredNorm();
  const auto [least, most] = stretch_of(*probe.info, probe.points[0]);
  const double stretch = std::clamp(-left.dot(changes.col(0)) / power, least, most);
  result.gain_nats = 0.5 * (left.squaredNorm() - (left + stretch * changes.col(0)).squaredNorm());
  for (std::size_t i = 0; i < probe.info->parameters.size(); ++i) {
    const ParameterInfo& parameter = probe.info->parameters[i];
    if (!parameter.scales_effect || !vanishes_at_zero(parameter)) continue;
    result.start.parameters[i] =
        std::clamp(stretch * result.start.parameters[i], parameter.lower, parameter.upper);
  }
  return result;
}

// An effect as a fit would start with it, and what it changes of the residuals.
struct Change {
  TrialEffect start;
  Eigen::VectorXd change;
};

// `effect` with its size times `amount`; nothing where it cannot have that size.
std::optional<TrialEffect> resized(TrialEffect effect, double amount) {
  constexpr double least_amount = 0.1;
  constexpr double most_amount = 30.0;
  if (!(std::abs(amount) > least_amount) || !(std::abs(amount) < most_amount)) return std::nullopt;
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
    const ParameterInfo& parameter = effect.info->parameters[i];
    if (!parameter.scales_effect || !vanishes_at_zero(parameter)) continue;
    const double size = amount * effect.parameters[i];
    if (size < parameter.lower || size > parameter.upper) return std::nullopt;
    effect.parameters[i] = size;
  }
  return effect;
}

// What both together could explain.
std::optional<ScreenedPair> pair_of(const Change& one, const Change& other, const Eigen::VectorXd& left) {
  constexpr double alike = 0.98;  // cosine
  const double a = one.change.squaredNorm();
  const double b = other.change.squaredNorm();
  const double both = one.change.dot(other.change);
  const double determinant = a * b - both * both;
  if (!(determinant > (1.0 - alike * alike) * a * b)) return std::nullopt;
  const double p = -left.dot(one.change);
  const double q = -left.dot(other.change);
  const double first = (p * b - q * both) / determinant;
  const double second = (q * a - p * both) / determinant;
  const auto start = resized(one.start, first);
  const auto beside = resized(other.start, second);
  if (!start || !beside) return std::nullopt;
  return ScreenedPair{{*start, *beside}, 0.5 * (first * p + second * q)};
}

std::optional<ScreenedPair> best_pair(const std::vector<Change>& changes, double best_single_nats,
                                      const Eigen::VectorXd& left) {
  constexpr double times_the_best_single = 1.5;
  constexpr double least_gain_nats = 40.0;
  std::optional<ScreenedPair> best;
  double least = std::max(least_gain_nats, times_the_best_single * best_single_nats);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (changes[i].start.info == changes[j].start.info) continue;
      const auto pair = pair_of(changes[i], changes[j], left);
      if (!pair || pair->gain_nats <= least) continue;
      best = pair;
      least = pair->gain_nats;
    }
  }
  return best;
}

}  // namespace

Screening screen(const GapProblem& problem, const GapFit& fit, std::span<const EffectInfo* const> candidates,
                 const ForEach& for_each) {
  std::vector<Probe> probes;
  const std::vector<Pose> places = visited_places(problem, fit.model);
  for (const EffectInfo* info : candidates) add_probes(*info, places, problem.has_counts(), probes);

  const Eigen::MatrixXd basis = basis_of(problem.jacobian(fit.model, fit.residuals));
  const Eigen::Map<const Eigen::VectorXd> residual(fit.residuals.data(),
                                                   static_cast<Eigen::Index>(fit.residuals.size()));
  const Eigen::VectorXd left = residual - basis * (basis.transpose() * residual);
  const auto only = [&](Part part) -> Eigen::VectorXd {
    const std::vector<double> values = problem.residuals(fit.model, part);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), residual.size());
  };
  const Eigen::VectorXd of_wheels = only(Part::wheels);
  const Eigen::VectorXd of_motion = only(Part::motion);
  const auto change_by = [&](const TrialEffect& effect) -> Eigen::VectorXd {
    TrialModel with = fit.model;
    with.effects.push_back(effect);
    const Part part = problem.part_of(effect);
    const std::vector<double> there = problem.residuals(with, part);
    const Eigen::Map<const Eigen::VectorXd> changed(there.data(), residual.size());
    const Eigen::VectorXd change = changed - (part == Part::all      ? residual
                                              : part == Part::wheels ? of_wheels
                                                                     : of_motion);
    return change - basis * (basis.transpose() * change);
  };
  std::vector<Screened> judgements(probes.size());
  std::vector<double> nats(probes.size(), 0.0);
  for_each(probes.size(), [&](std::size_t p) {
    const Probe& probe = probes[p];
    Eigen::MatrixXd changes(residual.size(), static_cast<Eigen::Index>(probe.points.size()));
    for (std::size_t i = 0; i < probe.points.size(); ++i) {
      changes.col(static_cast<Eigen::Index>(i)) = change_by({probe.info, probe.variant, probe.points[i]});
    }
    judgements[p] = judged(probe, changes, left);
    nats[p] = 0.5 * changes.rowwise().sum().squaredNorm();
  });

  Screening result;
  for (std::size_t p = 0; p < probes.size(); ++p) {
    result.visibility.push_back({{probes[p].info, probes[p].variant, probes[p].points[0]}, nats[p]});
    const auto same = std::ranges::find_if(result.best, [&](const Screened& other) {
      return other.start.info == probes[p].info && other.start.variant == probes[p].variant;
    });
    if (same == result.best.end()) {
      result.best.push_back(judgements[p]);
    } else if (judgements[p].gain_nats > same->gain_nats) {
      *same = judgements[p];
    }
  }
  std::ranges::sort(result.best, std::greater<>{}, &Screened::gain_nats);
  std::vector<Change> changes;
  double best_single_nats = 0.0;
  for (const auto& screened : result.best) {
    if (is_decoy(*screened.start.info)) continue;
    changes.push_back({screened.start, {}});
    best_single_nats = std::max(best_single_nats, screened.gain_nats);
  }
  for_each(changes.size(), [&](std::size_t i) { changes[i].change = change_by(changes[i].start); });
  std::erase_if(changes, [](const Change& change) { return !(change.change.squaredNorm() > 1e-12); });
  result.pair = best_pair(changes, best_single_nats, left);
  return result;
}

}  // namespace wheelwright::gap
