// SPDX-License-Identifier: Apache-2.0
#include "soak/worn_document.h"

#include "base/error.h"
#include "gl/context.h"
#include "soak/memory.h"
#include "studio/document/document_facts.h"
#include "studio/json/operation_json.h"
#include "studio/json/session_state.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <set>
#include <utility>

namespace vs::soak {

using studio::Operation;

namespace {

// Little, so that most of the history lies in the temporary file.
constexpr std::size_t kUndoMemory = std::size_t(50) << 10;
constexpr std::size_t kRemembered = 12; // operations, for those who look for a fault
constexpr int kTravelsOneIn = 25;       // steps
constexpr int kSavesOneIn = 250;
constexpr int kComparesOneIn = 10;
constexpr int kNotedOnTheWay = 8;

std::filesystem::path ownFolder() {
    static int count = 0;
    auto folder = std::filesystem::temp_directory_path() / fmt::format("vs_soak_{}_{}", getpid(), ++count);
    std::filesystem::create_directories(folder);
    return folder;
}

// What the document must be where it was that once, whatever has been looked at since and however much more
// can be redone: undo and redo lead to where parts lie, not to views.
studio::DocumentContent asSeenNow(studio::DocumentContent content, const studio::Document& document) {
    auto pasted = std::move(content.view.pasted);
    content.view = document.view();
    content.view.pasted = std::move(pasted);
    content.stepsUndone = document.history().undone().size();
    return content;
}

} // namespace

WornDocument::WornDocument(std::uint64_t seed)
    : random_(seed), any_([this](int n) { return below(n); }), folder_(ownFolder()),
      document_(std::make_unique<studio::Head>()) {
    document_->setUndoMemory(kUndoMemory);
}

WornDocument::~WornDocument() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

studio::DocumentContent WornDocument::contentNow() const { return studio::contentOf(*document_); }

void WornDocument::requireEqual(const studio::DocumentContent& wanted, const std::string& when) const {
    const auto found = studio::differences(wanted, contentNow(), "what was wanted", "the document");
    if (!found.empty()) {
        throw Fault(fmt::format("{}: {}; the last operations:\n{}", when, fmt::join(found, "; "),
                                fmt::join(last_, "\n")));
    }
}

// A seed and a trim that are taken back: from then on there is room for segments and for what is trimmed,
// which the start has too.
void WornDocument::begin() {
    studio::Clip trim;
    trim.planes = {{{35, 39, 30}, {0, 0, 1}}};
    for (const Operation& operation : {Operation(test::brainSeed()), Operation(trim)}) {
        document_->apply(operation);
        document_->apply(studio::Undo{});
    }
    start_ = contentNow();
}

bool WornDocument::done(const Operation& operation) {
    try {
        document_->apply(operation, folder_);
        ++done_[studio::name(operation)];
        return true;
    } catch (const Error& error) {
        const std::string reason = error.what();
        if (reason.empty() || reason.find('\n') != std::string::npos) {
            throw Fault(fmt::format("{} is not refused in one line: '{}'", toJson(operation).dump(), reason));
        }
        return false;
    }
}

void WornDocument::remember(std::string what) {
    last_.push_back(std::move(what));
    if (last_.size() > kRemembered) {
        last_.erase(last_.begin());
    }
}

void WornDocument::operate() {
    const Operation operation = any_.anything();
    const std::string name = studio::name(operation);
    remember(toJson(operation).dump());
    const bool isCompared = below(kComparesOneIn) == 0;
    const auto before = isCompared ? contentNow() : studio::DocumentContent();
    ++tried_;
    ++drawn_[name];
    if (done(operation)) {
        return;
    }
    ++refused_;
    if (isCompared) {
        ++refusalsCompared_;
        requireEqual(before, "a refused operation changed the document");
    }
}

// Some steps back and all of them forth again, unless it is left there and goes on from the past.
void WornDocument::travel() {
    const auto before = contentNow();
    const std::size_t canRedo = document_->history().undone().size();
    int steps = 0;
    for (int wanted = 1 + below(30); steps < wanted && done(studio::Undo{}); ++steps) {
    }
    if (below(6) == 0) {
        return;
    }
    for (int n = 0; n < steps; ++n) {
        if (!done(studio::Redo{})) {
            throw Fault(fmt::format("step {} of {} that were undone cannot be redone", n + 1, steps));
        }
    }
    ++journeys_;
    remember(fmt::format("{} times undo and redo, {} more could be redone", steps, canRedo));
    requireEqual(before, "undone and redone");
}

void WornDocument::saveAndOpen() {
    studio::Session source;
    source.volumePath = folder_ / "head.raw"; // which nobody reads here
    const auto file = folder_ / "head.json";
    std::vector<std::string> notices;
    studio::saveDocument(file, *document_, source, notices);
    volume::Volume head = test::testHead();
    auto state = studio::loadState(file, studio::loadSession(file), head, notices);
    if (!notices.empty() || (!state && document_->history().canUndo())) {
        throw Fault(fmt::format("saved and opened again: {}", fmt::join(notices, "; ")));
    }
    if (!state) {
        return; // nothing was done
    }
    const auto before = contentNow();
    document_ = std::make_unique<studio::Document>(std::move(head), std::move(*state));
    document_->setUndoMemory(kUndoMemory);
    ++savings_;
    requireEqual(before, "saved and opened again");
}

void WornDocument::step() {
    operate();
    if (below(kTravelsOneIn) == 0) {
        travel();
    }
    if (below(kSavesOneIn) == 0) {
        saveAndOpen();
    }
}

std::size_t WornDocument::undoAll() {
    onTheWay_.clear();
    const std::size_t all = document_->history().done().size();
    onTheWay_[all] = contentNow();
    for (std::size_t n = 1; done(studio::Undo{}); ++n) {
        if (n % (all / kNotedOnTheWay + 1) == 0) {
            onTheWay_[all - n] = contentNow();
        }
    }
    if (document_->history().canUndo()) {
        throw Fault(fmt::format("{} of {} steps cannot be undone", document_->history().done().size(), all));
    }
    return all;
}

void WornDocument::requireAsAtTheStart() {
    requireEqual(asSeenNow(start_, *document_), "undone to the start");
}

void WornDocument::redoAll() {
    const std::size_t most = onTheWay_.rbegin()->first;
    for (std::size_t n = 1; n <= most; ++n) {
        if (!done(studio::Redo{})) {
            throw Fault(fmt::format("step {} of {} cannot be redone", n, most));
        }
        const auto noted = onTheWay_.find(n);
        if (noted != onTheWay_.end()) {
            requireEqual(asSeenNow(noted->second, *document_), fmt::format("{} steps redone", n));
        }
    }
}

void WornDocument::doTheSame() {
    document_->showView(start_.view);
    studio::KeepConnected keep;
    keep.voxel = glm::ivec3(35, 11, 29); // of the skull
    std::vector<Operation> all{test::brainSeed(),
                               studio::Grow{3},
                               test::somePeel(),
                               keep,
                               studio::BrushSegment{true, test::somePeel()},
                               studio::Paste{}};
    for (const render::Mode mode : render::kModes) {
        studio::SetView view;
        view.mode = mode;
        all.emplace_back(view);
        all.emplace_back(studio::SavePicture{"same.png", {48, 36}, 1});
    }
    for (const Operation& operation : all) {
        document_->apply(operation, folder_);
    }
    document_->showView(start_.view);
    while (done(studio::Undo{})) {
    }
    gl::Context::finish();
}

void WornDocument::forgetHistory() {
    doTheSame();
    document_->apply(studio::Note{"here"}); // what comes after a step back forgets what could be redone
    document_->apply(studio::Undo{});
    onTheWay_.clear();
    (void)document_->facts(); // which have the history too
}

void WornDocument::renew() {
    document_.reset();
    document_ = std::make_unique<studio::Head>();
    document_->setUndoMemory(kUndoMemory);
    begin();
    forgetHistory();
}

std::size_t WornDocument::logBytes() const {
    std::size_t shared = 0; // label maps that were read, which copies of the log do not copy
    std::set<const void*> maps;
    for (const Operation& operation : document_->log()) {
        const auto* labels = std::get_if<studio::LoadLabels>(&operation);
        if (labels != nullptr && labels->map && maps.insert(labels->map.get()).second) {
            shared += labels->map->labels.capacity();
        }
    }
    return shared + heapBytesOf(document_->log());
}

std::size_t WornDocument::historyBytes() const {
    std::size_t records = 0;
    std::set<const void*> pastes;
    const auto& history = document_->history();
    for (const auto* edits : {&history.done(), &history.undone()}) {
        for (const studio::Edit& edit : *edits) {
            for (const auto& record : edit.growth) {
                records += record.bytes();
            }
            records += edit.trim ? edit.trim->held().size() : 0;
            for (const auto* list : {&edit.segmentsBefore, &edit.segmentsAfter}) {
                records += *list ? (*list)->segments.capacity() * sizeof(studio::SegmentInfo) : 0;
            }
            for (const auto* list : {&edit.measurementsBefore, &edit.measurementsAfter}) {
                records += *list ? (*list)->size() * sizeof(studio::Measure) : 0;
            }
            for (const auto* parts : {&edit.partsBefore, &edit.partsAfter}) {
                if (*parts && (*parts)->last) {
                    pastes.insert((*parts)->last.get());
                }
            }
        }
    }
    const auto statistics = history.statistics();
    records += (history.done().size() + history.undone().size()) * (sizeof(studio::Edit) + sizeof(Operation));
    return records + statistics.bytesInMemory + pastes.size() * start_.sculpture.size();
}

void WornDocument::requireAllTried() const {
    std::vector<std::string> never;
    for (const char* name : studio::operationNames()) {
        if (done_.count(name) == 0) {
            never.push_back(
                fmt::format("{} (drawn {} times)", name, drawn_.count(name) == 0 ? 0 : drawn_.at(name)));
        }
    }
    if (!never.empty()) {
        throw Fault(fmt::format("these were never done: {}", fmt::join(never, ", ")));
    }
}

} // namespace vs::soak
