// SPDX-License-Identifier: Apache-2.0
#include "gpu/faults/acts.h"

#include "gpu/faults/everything.h"
#include "gpu/studio/test_head.h"
#include "studio/json/operation_json.h"

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <new>
#include <numeric>
#include <random>

namespace vs::studio {

using test::RefusedAllocation;

namespace {

std::string chosen(const char* variable, const char* otherwise) {
    const char* value = std::getenv(variable);
    return value != nullptr ? value : otherwise;
}

std::size_t triedOf(std::size_t count) {
    const std::string most = chosen("VS_FAULTS", "12");
    return most == "all" ? count : std::min<std::size_t>(count, std::stoul(most));
}

// The numbers of the allocations to be refused, of so many: spread evenly, each somewhere in its part.
std::vector<std::size_t> numbersOf(std::size_t count, unsigned act) {
    std::vector<std::size_t> numbers;
    std::mt19937 random(act + 1000 * unsigned(std::stoul(chosen("VS_FAULTS_SEED", "1"))));
    const std::size_t parts = triedOf(count);
    for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t first = part * count / parts;
        const std::size_t next = (part + 1) * count / parts;
        numbers.push_back(1 + first + random() % (next - first));
    }
    return numbers;
}

} // namespace

Act actOf(const Operation& operation, const std::filesystem::path& folder) {
    Act act{toJson(operation).dump().substr(0, 100),
            [operation, folder](Document& document) { document.apply(operation, folder); }};
    if (std::holds_alternative<Undo>(operation)) {
        act.takeBack = [](Document& document) { document.apply(Redo{}); };
    } else if (isEdit(operation)) {
        act.takeBack = [](Document& document) {
            if (document.history().canUndo()) {
                document.apply(Undo{});
            }
        };
    }
    return act;
}

void Faults::SetUp() {
    GlTest::SetUp();
    folder_ = std::filesystem::temp_directory_path() / ("vs_faults_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
}

void Faults::TearDown() {
    std::filesystem::remove_all(folder_);
    GlTest::TearDown();
}

// How many allocations each act makes when nothing is refused.
std::vector<std::size_t> Faults::countedIn(Document& document, const std::vector<Act>& acts) {
    std::vector<std::size_t> counts;
    for (const Act& act : acts) {
        const RefusedAllocation none(GetParam(), 0);
        act.work(document);
        counts.push_back(none.count());
    }
    return counts;
}

// Whether the act was done, though it was refused that allocation.
bool Faults::isDone(Document& document, const Act& act, std::size_t number) {
    if (std::getenv("VS_FAULTS_TOLD") != nullptr) {
        std::cerr << act.name << ": allocation " << number << "\n";
    }
    const auto before = contentOf(document);
    const std::size_t logged = document.log().size();
    bool hasHappened = false;
    try {
        const RefusedAllocation refused(GetParam(), number);
        try {
            act.work(document);
        } catch (...) {
            hasHappened = refused.hasHappened();
            throw;
        }
        refusals_ += refused.hasHappened() ? 1 : 0;
        return true;
    } catch (const std::bad_alloc&) {
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
    EXPECT_TRUE(hasHappened);
    ++refusals_;
    act.drop(document);
    for (const auto& difference : differences(before, contentOf(document), "before", "after")) {
        ADD_FAILURE() << act.name << ", allocation " << number << ": " << difference;
    }
    EXPECT_EQ(document.log().size(), logged) << act.name << ", allocation " << number;
    return false;
}

void Faults::refuseIn(const std::vector<Act>& acts) {
    Document untroubled(test::testHead());
    const auto counts = countedIn(untroubled, acts);
    Document document(test::testHead());
    const auto start = contentOf(document);
    for (std::size_t n = 0; n < acts.size(); ++n) {
        const bool isTried = acts[n].name.find(chosen("VS_FAULTS_IN", "")) != std::string::npos;
        for (const std::size_t number : numbersOf(isTried ? counts[n] : 0, unsigned(n))) {
            if (isDone(document, acts[n], number)) {
                acts[n].takeBack(document);
            }
            if (HasFailure()) {
                return;
            }
        }
        acts[n].work(document);
    }
    expectAlike(untroubled, document);
    while (document.history().canUndo()) {
        document.apply(Undo{});
    }
    const auto undone = contentOf(document);
    EXPECT_EQ(undone.sculpture, start.sculpture);
    EXPECT_TRUE(
        std::all_of(undone.labels.begin(), undone.labels.end(), [](auto label) { return label == 0; }));
    EXPECT_EQ(undone.segments, start.segments);
    EXPECT_EQ(undone.geometry, start.geometry);
    std::cout << refusals_ << " refused of " << std::accumulate(counts.begin(), counts.end(), std::size_t(0))
              << " allocations in " << acts.size() << " acts\n";
    EXPECT_GT(refusals_, chosen("VS_FAULTS_IN", "").empty() ? acts.size() : 0);
}

// What was done in spite of all that is what would have been done without, and looks so.
void Faults::expectAlike(Document& untroubled, Document& troubled) {
    auto one = contentOf(untroubled);
    const auto other = contentOf(troubled);
    one.stepsUndone = other.stepsUndone; // what was taken back to be done again may be among them
    for (const auto& difference : differences(one, other, "untroubled", "troubled")) {
        ADD_FAILURE() << difference;
    }
    for (const Operation& operation : test::picturesOfAll()) {
        EXPECT_TRUE(pictureOf(untroubled, operation) == pictureOf(troubled, operation))
            << toJson(operation).dump();
    }
}

// The bytes of its file; none of an operation that makes none.
std::string Faults::pictureOf(Document& document, const Operation& operation) {
    document.apply(operation, folder_);
    const auto* picture = std::get_if<SavePicture>(&operation);
    std::ifstream file(folder_ / (picture != nullptr ? picture->file : "none"), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace vs::studio
