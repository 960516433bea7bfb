// SPDX-License-Identifier: Apache-2.0
// Does what sanitizers must not let pass: the fault that its argument names.
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

// What the compiler cannot see through.
int hidden(int value) {
    volatile int kept = value;
    return kept;
}

void readPastTheEnd() {
    const auto values = std::make_unique<int[]>(std::size_t(hidden(4)));
    std::cout << values[std::size_t(hidden(4))] << '\n';
}

void readPastTheEndOfAVector() {
    const std::vector<int> values(std::size_t(hidden(4)));
    std::cout << values[std::size_t(hidden(4))] << '\n';
}

void overflow() { std::cout << std::numeric_limits<int>::max() + hidden(1) << '\n'; }

void leak() {
    auto* lost = new int[100];
    lost[0] = hidden(1);
    std::cout << lost[0] << '\n';
}

void race() {
    int counter = 0;
    const auto count = [&counter] {
        for (int i = 0; i < 10000; ++i) {
            ++counter;
        }
    };
    std::jthread other(count);
    count();
}

} // namespace

int main(int argc, char** argv) {
    const std::map<std::string, std::function<void()>> faults{{"none", [] {}},
                                                              {"past_the_end", readPastTheEnd},
                                                              {"past_a_vectors_end", readPastTheEndOfAVector},
                                                              {"overflow", overflow},
                                                              {"leak", leak},
                                                              {"race", race}};
    faults.at(argc == 2 ? argv[1] : "none")();
    return EXIT_SUCCESS;
}
