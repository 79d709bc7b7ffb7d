/// A document, the walk in it, and how frames of it come, put together.
#pragma once

#include "rtserver/document/document.h"
#include "rtserver/document/pack_progress.h"
#include "rtserver/walk/walk.h"

#include <memory>
#include <utility>

namespace rtserver {

struct Measuring;
class StoreyOutlines;

/// `options` and `messages` must outlive it.
struct Workspace {
    Workspace(const Options& options, Document::Reserve reserve, Messages& messages)
        : document(options, std::move(reserve), messages), walk(document, messages, options.path),
          frameSeconds(options.frameSeconds), threads(options.threads) {}

    Document document;
    Walk walk;
    bool paused = false;
    double frameSeconds; ///< what a frame may take while something moves: fewer pixels then; 0: any time
    int threads;         ///< Options::threads
    /// The indirect light of whole frames that nothing is written from is what the walk has learned.
    bool restsInWalkLight = false;
    bool wantsExact = false; ///< a frame is to be written: it depends on the state alone
    bool idles = true;       ///< false: every frame is drawn, though it equals the last
    std::shared_ptr<PackProgress> packing = nullptr;    ///< of the pack that is being made; null: none is
    std::shared_ptr<Measuring> measuring = nullptr;     ///< the light that is being measured; null: none is
    std::shared_ptr<StoreyOutlines> outlines = nullptr; ///< once one was asked for
};

} // namespace rtserver
