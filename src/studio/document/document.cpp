// SPDX-License-Identifier: Apache-2.0
#include "studio/document/document.h"

#include "base/check.h"
#include "base/progress.h"
#include "field/finer_cells.h"
#include "studio/document/document_impl.h"
#include "studio/document/finer_levels.h"

namespace vs::studio {

Document::Document(volume::Volume volume, sculpt::Precision precision)
    : impl_(std::make_unique<Impl>(std::move(volume), precision)) {}
Document::~Document() = default;

const volume::Volume& Document::volume() const { return impl_->contents.scan.volume; }
const volume::GridGeometry& Document::geometryInFile() const { return impl_->contents.scan.inFile; }
LabelGrids Document::labelGrids() const { return impl_->contents.labelGrids(); }
const field::Field& Document::field() const { return impl_->contents.scan.field; }
const std::vector<std::uint32_t>& Document::histogram() const { return impl_->contents.scan.histogram; }
const View& Document::view() const { return impl_->contents.view; }
const SegmentList& Document::segments() const { return impl_->contents.segments; }
const Region& Document::region() const { return impl_->contents.region; }
const sculpt::Sculpture& Document::sculpture() const { return impl_->contents.sculpture; }
const sculpt::Trimmed& Document::trimmed() const { return impl_->contents.trimmed; }
const History& Document::history() const { return impl_->contents.history; }
const std::vector<Operation>& Document::log() const { return impl_->log.operations(); }
std::uint64_t Document::version() const { return impl_->contents.version; }

std::uint64_t Document::pictureVersion() const {
    return impl_->contents.version - impl_->contents.sliceChanges;
}
void Document::showFinerLevels(const FinerLevels& levels) {
    Contents& contents = impl_->contents;
    Scan& scan = contents.scan;
    std::shared_ptr<const volume::BrickSource> source = levels.source;
    if (source == nullptr) {
        source = std::make_shared<volume::VolumeBricks>(scan.volume, scan.inFile);
    }
    auto detail = std::make_unique<field::Detail>(source, scan.inFile, levels.options);
    const field::BrickGrid& finest = detail->grids().front();
    const bool needsScenes = !finest.isFiner() || (levels.extremes && !levels.isAllKnown);
    std::optional<field::CellRanges> ofScene;
    if (needsScenes) {
        ofScene = field::computeCellRanges(scan.field);
    }
    field::CellRanges cells = !finest.isFiner()
                                  ? std::move(*ofScene)
                                  : field::finerCellRanges(scan.inFile.dims, finest, levels.extremes,
                                                           ofScene ? &*ofScene : nullptr);
    if (finest.isFiner()) {
        Cutter::Finer finer = impl_->cutter.makeFiner(scan.field);
        contents.sculpture.refine(
            std::make_unique<sculpt::FineSculpture>(finest, contents.sculpture.precision()));
        // From here on nothing fails. Quads would take memory that bricks are to have.
        scan.field.quads = {};
        scan.field.mayHaveQuads = false;
        impl_->cutter.refine(std::move(finer), *detail);
        if (!contents.region.exists()) {
            contents.region.refine({source, finest, levels.options.hostBytes, levels.options.threads});
        }
    }
    impl_->display.showFiner(*detail, std::move(cells));
    scan.levels = source;
    scan.detail = std::move(detail);
    ++contents.version;
}

std::shared_ptr<const volume::BrickSource> Document::levels() const { return impl_->contents.scan.levels; }
const field::Detail* Document::detail() const { return impl_->contents.scan.detail.get(); }

void Document::setUndoMemory(std::size_t bytes) { impl_->contents.history.setMemoryLimit(bytes); }
LiveStroke& Document::stroke() { return impl_->liveStroke; }
const field::SharedMarks& Document::marks() const { return impl_->contents.marks; }
const Filled& Document::filled() const { return impl_->contents.filled; }
LiveMark& Document::mark() { return impl_->liveMark; }
LiveGrowth& Document::growing() { return impl_->liveGrowth; }
SurfaceQueries& Document::surface() { return impl_->surface; }
PartQueries& Document::parts() { return impl_->partQueries; }

const std::vector<std::uint32_t>* Document::visibleHistogram(double budgetMs) {
    return impl_->visibleHistogram.count(impl_->contents, budgetMs);
}

std::shared_ptr<const DocumentFacts> Document::facts() const {
    const Contents& contents = impl_->contents;
    auto& known = impl_->facts;
    if (!known || known->version != contents.version || known->logged != log().size() ||
        known->inHand != contents.inHand || known->edits->revision != contents.history.revision()) {
        known = factsOf(contents, log().size(), known ? *known : DocumentFacts());
    }
    return known;
}

// --- operations

Outcome Document::apply(const Operation& operation, const std::filesystem::path& outputFolder,
                        std::span<const Operation> coming) {
    VS_CHECK(impl_->isIdle());
    const Timer timer;
    Outcome outcome = impl_->runOrNothing(operation, outputFolder, coming);
    outcome.milliseconds = timer.milliseconds();
    return outcome;
}

Outcome Document::replaceLast(const Operation& operation) {
    VS_CHECK(impl_->isIdle());
    History& history = impl_->contents.history;
    const auto isOfTheKind = [&](const Operation& other) { return other.index() == operation.index(); };
    if (!history.canUndo() || history.canRedo() || !impl_->log.canMerge(view()) ||
        !isOfTheKind(impl_->log.last()) || !isOfTheKind(history.lastOperation())) {
        return apply(operation);
    }
    impl_->travel(history.toUndo(), true);
    impl_->log.placesAre(view().pasted);
    history.forgetLast();
    const Operation replaced = impl_->log.takeLast();
    try {
        return apply(operation);
    } catch (...) {
        const ProgressListener toTheEnd(
            [](auto) { return true; }); // what is put back is not given up as well
        apply(replaced);
        throw;
    }
}

Outcome Document::rewindFurther(int generations) {
    History& history = impl_->contents.history;
    const bool continues = impl_->log.canMerge(view()) && std::holds_alternative<Rewind>(impl_->log.last()) &&
                           !history.canRedo() && history.canUndo() &&
                           std::holds_alternative<Rewind>(history.lastOperation());
    const int before = continues ? std::get<Rewind>(impl_->log.last()).generations : 0;
    Outcome outcome = apply(Rewind{generations});
    if (continues) {
        try {
            const Rewind both{before + generations};
            history.mergeLastTwo(shared(both));
            impl_->log.takeLast();
            impl_->log.last() = both;
        } catch (const std::bad_alloc&) { // then they stay two
        }
    }
    return outcome;
}

void Document::seal() { impl_->log.seal(); }

void Document::logOutput(const Operation& operation) {
    VS_CHECK(isOutput(operation));
    impl_->log.record(operation, view());
}

void Document::showView(const View& view) { impl_->contents.show(view); }

// --- pictures

render::Frame Document::frame(glm::ivec2 size, double segmentsMs) {
    return impl_->display.frame(view(), size, segmentsMs);
}

const PictureContent& Document::content() const { return impl_->display.content(); }

std::optional<Box3> Document::changedSince(const PictureContent& before) const {
    return impl_->display.changedSince(before);
}

render::SliceFrame Document::slice(const render::SliceView& view, double segmentsMs) {
    return impl_->display.slice(view, segmentsMs);
}

bool Document::isBehind() const { return impl_->display.isBehind(); }

render::TransferFunction Document::resolved(const render::TransferFunction& function) {
    return impl_->display.resolved(function);
}

} // namespace vs::studio
