// How far estimates would scatter if the same blocks of time came again by chance: a block bootstrap.
//
// Each draw gives every block a random weight (exponential, mean 1) instead of drawing blocks with
// replacement, so that a draw never lacks the only block that shows a parameter (Xu, Gotwalt, Hong, King and
// Meeker, "Applications of the fractional-random-weight bootstrap", The American Statistician 74 (2020)
// 345-358). The weighted problem is solved by one Gauss-Newton step from the estimate, which is as good as a
// whole fit to the order of the bootstrap itself (Davidson and MacKinnon, "Bootstrap testing in nonlinear
// models", International Economic Review 40 (1999) 487-508).
#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

namespace wheelwright::gap {

// Of the residuals r of one block and their derivatives J by the parameters.
struct BlockSums {
  Eigen::MatrixXd information;  // transpose(J) J
  Eigen::VectorXd gradient;     // transpose(J) r
};

struct Bootstrap {
  Eigen::MatrixXd deviations;        // from the estimate, one row per parameter, one column per draw
  Eigen::VectorXd white_deviations;  // standard deviations if the residuals were white with variance 1
};

// Parameters of which nothing is known stay where they are. The same arguments give the same draws.
Bootstrap block_bootstrap(std::span<const BlockSums> blocks, std::size_t draws, std::uint64_t seed);

}  // namespace wheelwright::gap
