#pragma once

#include <utility>
#include <vector>

#include "tests/benchmark/plants/random.hpp"

namespace plants {

template <class Item>
void shuffle(std::vector<Item>& items, Random random) {
  for (std::size_t left = items.size(); left > 1; --left)
    std::swap(items[left - 1],
              items[static_cast<std::size_t>(random.integer(0, static_cast<int>(left) - 1))]);
}

}  // namespace plants
