#include <iostream>

#include "tools/wheelwright/common/command_line.hpp"

int main(int argc, char** argv) {
  const auto status = wheelwright::tools::run_command_line({argv + 1, argv + argc}, {std::cout, std::cerr});
  return static_cast<int>(status);
}
