// SPDX-License-Identifier: Apache-2.0
// No memory in the midst of an operation: it is done after all, or throws and the document is as it was, to
// the byte. Some allocations of each operation are tried; VS_FAULTS chooses how many of each, or "all".
// VS_FAULTS_SEED makes others of them be tried. With VS_FAULTS_TOLD each one is told before it is tried.
#include "gpu/faults/everything.h"
#include "gpu/faults/faults.h"
#include "gpu/gl_test.h"
#include "gpu/studio/test_labels.h"
#include "studio/document/document_content.h"
#include "studio/json/operation_json.h"

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <numeric>
#include <random>
#include <set>

namespace vs::studio {
namespace {

using test::Memory;
using test::RefusedAllocation;

std::string chosen(const char* variable, const char* otherwise) {
    const char* value = std::getenv(variable);
    return value != nullptr ? value : otherwise;
}

std::size_t triedOf(std::size_t count) {
    const std::string most = chosen("VS_FAULTS", "12");
    return most == "all" ? count : std::min<std::size_t>(count, std::stoul(most));
}

// The numbers of the allocations to be refused, of so many: spread evenly, each somewhere in its part.
std::vector<std::size_t> numbersOf(std::size_t count, unsigned operation) {
    std::vector<std::size_t> numbers;
    std::mt19937 random(operation + 1000 * unsigned(std::stoul(chosen("VS_FAULTS_SEED", "1"))));
    const std::size_t parts = triedOf(count);
    for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t first = part * count / parts;
        const std::size_t next = (part + 1) * count / parts;
        numbers.push_back(1 + first + random() % (next - first));
    }
    return numbers;
}

class Faults : public test::GlTest, public ::testing::WithParamInterface<Memory> {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder_ = std::filesystem::temp_directory_path() / ("vs_faults_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        GlTest::TearDown();
    }

    // How many allocations each operation makes when nothing is refused.
    std::vector<std::size_t> countedIn(Document& document, const std::vector<Operation>& operations) {
        std::vector<std::size_t> counts;
        for (const Operation& operation : operations) {
            const RefusedAllocation none(GetParam(), 0);
            document.apply(operation, folder_);
            counts.push_back(none.count());
        }
        return counts;
    }

    // Whether the operation was done, though it was refused that allocation.
    bool isDone(Document& document, const Operation& operation, std::size_t number) {
        if (std::getenv("VS_FAULTS_TOLD") != nullptr) {
            std::cerr << name(operation) << ": allocation " << number << "\n";
        }
        const auto before = contentOf(document);
        const std::size_t logged = document.log().size();
        bool hasHappened = false;
        try {
            const RefusedAllocation refused(GetParam(), number);
            try {
                document.apply(operation, folder_);
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
        for (const auto& difference : differences(before, contentOf(document), "before", "after")) {
            ADD_FAILURE() << toJson(operation).dump() << ", allocation " << number << ": " << difference;
        }
        EXPECT_EQ(document.log().size(), logged) << name(operation) << ", allocation " << number;
        return false;
    }

    // Goes back to before an operation that was done, where that can be.
    static void takeBack(Document& document, const Operation& operation) {
        if (std::holds_alternative<Undo>(operation)) {
            document.apply(Redo{});
        } else if (isEdit(operation) && document.history().canUndo()) {
            document.apply(Undo{});
        }
    }

    std::filesystem::path folder_;
    std::size_t refusals_ = 0;
};

TEST_P(Faults, LeaveTheDocumentAsItWas) {
    const test::LabelFile labels;
    const auto operations = test::everything(labels.path());
    Document untroubled(test::testHead());
    const auto counts = countedIn(untroubled, operations);

    Document document(test::testHead());
    const auto start = contentOf(document);
    for (std::size_t n = 0; n < operations.size(); ++n) {
        for (const std::size_t number : numbersOf(counts[n], unsigned(n))) {
            if (isDone(document, operations[n], number)) {
                takeBack(document, operations[n]);
            }
            if (HasFailure()) {
                return;
            }
        }
        document.apply(operations[n], folder_);
    }
    // What was done in spite of all that is what would have been done without.
    auto one = contentOf(untroubled);
    auto other = contentOf(document);
    other.stepsUndone = one.stepsUndone;
    for (const auto& difference : differences(one, other, "untroubled", "troubled")) {
        ADD_FAILURE() << difference;
    }
    while (document.history().canUndo()) {
        document.apply(Undo{});
    }
    auto undone = contentOf(document);
    EXPECT_EQ(undone.sculpture, start.sculpture);
    EXPECT_TRUE(
        std::all_of(undone.labels.begin(), undone.labels.end(), [](auto label) { return label == 0; }));
    EXPECT_EQ(undone.segments, start.segments);
    EXPECT_EQ(undone.geometry, start.geometry);
    std::cout << refusals_ << " refused of " << std::accumulate(counts.begin(), counts.end(), std::size_t(0))
              << " allocations in " << operations.size() << " operations\n";
    EXPECT_GT(refusals_, operations.size());
}

INSTANTIATE_TEST_SUITE_P(OnHostAndDevice, Faults, ::testing::Values(Memory::Host, Memory::Device),
                         [](const auto& tried) { return tried.param == Memory::Host ? "Host" : "Device"; });

TEST(FaultsOperations, AreAllThereAre) {
    std::set<std::string> tried;
    for (const Operation& operation : test::everything("labels.nrrd")) {
        tried.insert(name(operation));
    }
    for (const char* name : operationNames()) {
        EXPECT_TRUE(tried.contains(name)) << name;
    }
}

} // namespace
} // namespace vs::studio
