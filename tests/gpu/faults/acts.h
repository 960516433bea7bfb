// SPDX-License-Identifier: Apache-2.0
// What is done with a document while memory is refused.
#pragma once

#include "gpu/faults/faults.h"
#include "gpu/gl_test.h"
#include "studio/document/document.h"
#include "studio/document/document_content.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace vs::studio {

struct Act {
    std::string name;
    std::function<void(Document&)> work;
    // Goes back to before an act that was done.
    std::function<void(Document&)> takeBack = [](Document&) {};
    // After it has thrown, nothing refused any more: drops what is in hand.
    std::function<void(Document&)> drop = [](Document&) {};
};

Act actOf(const Operation& operation, const std::filesystem::path& folder);

// Each act with some of its allocations refused, one at a time: it is done after all, or throws and the
// document is as it was, to the byte.
class Faults : public test::GlTest, public ::testing::WithParamInterface<test::Memory> {
protected:
    void SetUp() override;
    void TearDown() override;

    // Does all of them, with and without troubles, and compares the two documents that come of it.
    void refuseIn(const std::vector<Act>& acts);
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
    std::vector<std::size_t> countedIn(Document& document, const std::vector<Act>& acts);
    bool isDone(Document& document, const Act& act, std::size_t number);
    void expectAlike(Document& untroubled, Document& troubled);
    [[nodiscard]] std::string pictureOf(Document& document, const Operation& picture);

    std::filesystem::path folder_;
    std::size_t refusals_ = 0;
};

} // namespace vs::studio
