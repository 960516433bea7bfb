// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/studio/any_operation.h"
#include "studio/document/document_content.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace vs::soak {

// Something that must not happen has happened.
class Fault : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// A document that is worked on at random, as one seed says, and what it must be afterwards. What is wrong
// throws Fault.
class WornDocument {
public:
    explicit WornDocument(std::uint64_t seed);
    ~WornDocument();
    WornDocument(const WornDocument&) = delete;
    WornDocument& operator=(const WornDocument&) = delete;

    // Notes what the document is at first, to which undoing everything must lead back.
    void begin();
    // One random operation; or now and then a way back and forth through the history, or a session with state
    // that is saved and opened again and worked on from then on. What is refused must change nothing.
    void step();
    // Undoes everything and notes what the document is on the way. Returns the number of steps.
    std::size_t undoAll();
    void requireAsAtTheStart();
    // Redoes all that undoAll() has undone, comparing with what it noted.
    void redoAll();
    // What could be redone is not kept any more; nothing may be left to undo. Before, the same short work is
    // done each time: drivers keep what was bound last, and that is then the same too.
    void forgetHistory();
    // Becomes a new document, in which the same short work is done.
    void renew();

    // What the log takes, with what it shares with none but the history.
    [[nodiscard]] std::size_t logBytes() const;
    // What undo and redo keep in memory, as far as it can be counted: contents of cuts and trims, records of
    // growth, lists, and of each paste what was cut then, a texture of the sculpture's size.
    [[nodiscard]] std::size_t historyBytes() const;
    // Throws when an operation's name was never drawn, or never done.
    void requireAllTried() const;

    [[nodiscard]] const studio::Document& document() const { return *document_; }
    [[nodiscard]] int tried() const { return tried_; }
    [[nodiscard]] int refused() const { return refused_; }
    [[nodiscard]] int refusalsCompared() const { return refusalsCompared_; }
    [[nodiscard]] int savings() const { return savings_; }
    [[nodiscard]] int journeys() const { return journeys_; }

private:
    [[nodiscard]] int below(int n) { return int(random_() % std::uint64_t(n)); }
    bool done(const studio::Operation& operation);
    void remember(std::string what);
    void doTheSame();
    void operate();
    void travel();
    void saveAndOpen();
    [[nodiscard]] studio::DocumentContent contentNow() const;
    void requireEqual(const studio::DocumentContent& wanted, const std::string& when) const;

    std::mt19937_64 random_;
    test::AnyOperation any_;
    std::filesystem::path folder_; // for what it writes
    std::unique_ptr<studio::Document> document_;
    studio::DocumentContent start_;
    std::map<std::size_t, studio::DocumentContent> onTheWay_; // by the number of steps that are done
    std::map<std::string, int> drawn_, done_;                 // by the operation's name
    std::vector<std::string> last_;                           // operations, to say what led to a fault
    int tried_ = 0;
    int refused_ = 0;
    int refusalsCompared_ = 0;
    int savings_ = 0;
    int journeys_ = 0;
};

} // namespace vs::soak
