// Writes the cases of the sixth plant.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "tests/benchmark/sixth_plant/exam_writer.hpp"

int main(int argc, char** argv) {
  plants::sixth::ExamOptions options;
  CLI::App app{"Writes drive logs of a small educational robot in which effects are hidden.", "sixth_plant"};
  app.add_option("--seed", options.seed, "Robots, drives and noise")->capture_default_str();
  app.add_option("--matching", options.matching, "Cases whose name matches, as coulomb_friction");
  app.add_flag("--verbose", options.verbose, "Also say how large each effect is, and how far it shows");
  app.add_option("-o,--output", options.output, "Folder for the folders of the cases")->capture_default_str();
  try {
    app.parse(argc, argv);
    plants::sixth::write_exam(options);
    return 0;
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sixth_plant: %s\n", error.what());
    return 2;
  }
}
