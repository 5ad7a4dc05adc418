#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/benchmark/solver/other_solvers.hpp"

namespace wheelwright::benchmarks {
namespace {

// Columns 1 and 2 are the commands, the last one is the speed. arx counts its inputs from lag nk on: 0 to 9.
constexpr const char* script = R"(
pkg load control
table = dlmread(argv(){1});
u = table(:, 1:2);
y = table(:, 3);
data = iddata(y, u, 0.018);
arx(data, 'na', 9, 'nb', [10 10], 'nk', [0 0]);
tic;
model = arx(data, 'na', 9, 'nb', [10 10], 'nk', [0 0]);
seconds = toc;
a = model.den;
b = model.num;
if (iscell(a)), a = a{1, 1}; end
first = 10;
predicted = zeros(size(y));
for k = first:rows(y)
  predicted(k) = -a(2:10)(:).' * y(k-1:-1:k-9) + b{1, 1}(:).' * u(k:-1:k-9, 1) + b{1, 2}(:).' * u(k:-1:k-9, 2);
end
printf("%.17g %.17g\n", norm(y(first:end) - predicted(first:end)), seconds);
)";

}  // namespace

bool octave_installed() {
  return std::system("command -v octave-cli >/dev/null 2>&1") == 0;
}

std::optional<OctaveResult> solve_by_octave(const DenseSystem& system) {
  if (!octave_installed()) return std::nullopt;
  const auto folder = std::filesystem::temp_directory_path();
  const auto script_file = folder / "wheelwright_arx.m";
  const auto table_file = folder / "wheelwright_arx.csv";
  std::ofstream(script_file) << script;
  std::ofstream table(table_file);
  table.precision(17);
  for (Eigen::Index k = 0; k < system.a.rows(); ++k) {
    table << system.a(k, 0) << ',' << system.a(k, 1) << ',' << system.b[k] << '\n';
  }
  table.close();
  const std::string command =
      "octave-cli --no-gui --quiet " + script_file.string() + " " + table_file.string() + " 2>/dev/null";
  FILE* output = popen(command.c_str(), "r");
  if (output == nullptr) return std::nullopt;
  OctaveResult result;
  const int read = std::fscanf(output, "%lf %lf", &result.residual_norm, &result.seconds);
  pclose(output);
  std::filesystem::remove(script_file);
  std::filesystem::remove(table_file);
  if (read != 2) return std::nullopt;
  return result;
}

}  // namespace wheelwright::benchmarks
