// SPDX-License-Identifier: Apache-2.0
#include "studio/document/document_state.h"

#include "studio/document/document_impl.h"
#include "studio/document/saved_edits.h"

namespace vs::studio {

DocumentState Document::state() const {
    VS_CHECK(impl_->isIdle());
    const Contents& contents = impl_->contents;
    const sculpt::Sculpture& sculpture = contents.sculpture;
    DocumentState state;
    state.log = impl_->log.operations();
    state.view = contents.view;
    state.geometry = contents.scan.volume.geometry;
    state.precision = sculpture.precision();
    state.cut = sculpture.content();
    state.sculptureVersion = sculpture.version();
    state.sculptureContentVersion = sculpture.contentVersion();
    if (!contents.trimmed.isEmpty()) {
        state.trimmed = contents.trimmed.content(sculpture.precision());
    }
    if (contents.region.exists()) {
        state.growth = contents.region.growth()->snapshot();
    }
    state.segments = contents.segments;
    state.measurements = contents.measurements;
    state.marks = contents.marks;
    state.filled = contents.filled;
    KeptPastes pastes;
    state.parts = pastes.saved(contents.pasted);
    state.done = savedEdits(contents.history, contents.history.done(), pastes);
    state.undone = savedEdits(contents.history, contents.history.undone(), pastes);
    state.pastes = pastes.contents(state.precision);
    return state;
}

Document::Document(volume::Volume volume, DocumentState state)
    : Document(std::move(volume), state.precision) {
    Contents& contents = impl_->contents;
    if (!(state.geometry == contents.scan.volume.geometry)) {
        impl_->scan.lay(state.geometry); // tools too
    }
    contents.sculpture.restore(state.cut, state.sculptureVersion, state.sculptureContentVersion);
    if (state.trimmed) {
        contents.trimmed.restore(contents.sculpture, *state.trimmed);
    }
    const bool mayBeFenced = state.growth || !state.done.empty() || !state.undone.empty();
    const gl::Texture* fence = mayBeFenced ? &contents.sculpture.texels() : nullptr;
    if (state.growth) {
        contents.region.restore(fencedBy(std::move(*state.growth), fence));
    }
    contents.segments = std::move(state.segments);
    contents.measurements = std::move(state.measurements);
    contents.marks = std::move(state.marks);
    contents.filled = std::move(state.filled);
    const RestoredPastes pastes(state.pastes, contents.sculpture);
    contents.pasted = pastes.restored(state.parts);
    contents.history.restore(restoredEdits(std::move(state.done), pastes, fence),
                             restoredEdits(std::move(state.undone), pastes, fence));
    contents.view = state.view;
    ++contents.version;
    impl_->log = OperationLog(contents.view, std::move(state.log));
}

} // namespace vs::studio
