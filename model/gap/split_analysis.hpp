// One search and what follows from it, for one split of the runs into training and held-out ones.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/gap/analysis.hpp"
#include "model/gap/candidates/testability.hpp"
#include "model/gap/conclusion/found_model.hpp"
#include "model/gap/selection/search.hpp"

namespace wheelwright::gap {

// What all analyses of the same logs share. Each member must outlive them.
struct AnalysisContext {
  const GapOptions& options;
  const Testability& testability;
  const ParallelFor& parallel_for;
  const Progress& progress;
};

// What is known before a search: the runs, their purposes and their faults.
GapAnalysis analysis_before_search(const GatheredRuns& runs);

class SplitAnalysis {
 public:
  // Searches, and decides what of it is an answer. `runs` must have training and held-out runs.
  SplitAnalysis(GatheredRuns runs, const AnalysisContext& context);

  GapAnalysis& result() { return result_; }
  const GapAnalysis& result() const { return result_; }
  // With reference poses and wheel angles as the model found has them.
  GatheredRuns& runs() { return runs_; }
  const GatheredRuns& runs() const { return runs_; }
  const FitProblem& train() const { return *train_; }
  const FitProblem& held_out() const { return *held_out_; }
  const ModelOrigin& origin() const { return origin_; }
  bool names_small_effects() const { return context_.options.names_small_effects; }

  // Withdraws every effect that the search found, and gives the verdict on the linear model alone.
  void withdraw_names();
  // Withdraws these alone: the others are fitted again, and the verdict is given on them. At least one stays.
  void withdraw(const std::vector<std::string>& names);

  // Free runs of two models, and the noise floor of the second.
  GapFigures figures(const RobotModel& before, const RobotModel& after,
                     const std::vector<DriveLog>& logs) const;
  // The noise floor of the model found, with noise that drifts over two seconds.
  Score slow_floor(const std::vector<DriveLog>& logs) const;
  // The figure furthest above its floor, with noise that drifts over half a second and no more than sound
  // robots do.
  Excess over_credible_noise(const std::vector<DriveLog>& logs) const;

 private:
  void search();
  void note_references_by(const TrialModel& model);
  bool closes_the_gap() const;
  bool is_of_a_linear_part() const;
  void take_findings();
  void fit_without(const std::vector<std::string>& names);
  void conclude();
  bool leave_out_linear_effects();
  void remove_names();
  void judge();
  void describe_where();
  void size_up();
  void show_gap_with_lost_counts();
  void put_slow_noise_into_floors();

  AnalysisContext context_;
  GatheredRuns runs_;
  ModelOrigin origin_;
  std::optional<FitProblem> train_;
  std::optional<FitProblem> held_out_;
  bool linear_left_out_ = false;
  GapAnalysis result_;
};

}  // namespace wheelwright::gap
