// SPDX-License-Identifier: Apache-2.0
#include "model/texts/operation_texts.h"

#include "model/texts/library_texts.h"

#include "studio/operations/operation_names.h"

#include <QCoreApplication>

#include <map>
#include <string_view>

namespace vs::desktop {

namespace {

QString capitalised(const QString& text) { return text.left(1).toUpper() + text.mid(1); }

QString quoted(const std::string& name) { return "“" + QString::fromStdString(name) + "”"; }

// What there is to say besides the operation's name; empty: nothing.
struct Details {
    Q_DECLARE_TR_FUNCTIONS(vs::desktop::Details)

public:
    QString operator()(const studio::Peel& op) const {
        return tr("%1 layers").arg(QString::number(op.layers, 'g', 3)) + restoring(op.restores);
    }
    QString operator()(const studio::Scissors& op) const {
        return (op.cutsOutside ? tr("outside") : tr("inside")) + restoring(op.restores);
    }
    QString operator()(const studio::MovePart& op) const { return tr("part %1").arg(op.part + 1); }
    QString operator()(const studio::Grow& op) const {
        return op.generations ? generations(*op.generations) : tr("to the end");
    }
    QString operator()(const studio::Rewind& op) const { return generations(op.generations); }
    QString operator()(const studio::ShowGeneration& op) const { return QString::number(op.generation); }
    QString operator()(const studio::UseSegment& op) const { return quoted(op.name.value_or(op.segment)); }
    QString operator()(const studio::RemoveSegment& op) const { return quoted(op.segment); }
    QString operator()(const studio::EditSegment& op) const {
        return libraryText(studio::kSegmentEdits.at(std::size_t(op.kind)));
    }
    QString operator()(const studio::BrushSegment& op) const { return op.isToAdd ? tr("add") : tr("remove"); }
    QString operator()(const studio::CutSegment& op) const {
        return op.keeps ? tr("all but it") : tr("away");
    }
    template <typename Op>
    QString operator()(const Op& op) const {
        if constexpr (requires { op.restores; }) {
            return op.restores ? tr("restore") : QString();
        }
        return {};
    }

    static QString generations(int count) {
        return count == 1 ? tr("one generation") : tr("%1 generations").arg(count);
    }
    static QString restoring(bool restores) { return restores ? ", " + tr("restore") : QString(); }
};

} // namespace

QString describe(const studio::Operation& operation) {
    const QString details = std::visit(Details(), operation);
    const QString name = capitalised(libraryText(studio::name(operation)));
    return details.isEmpty() ? name : name + ", " + details;
}

const char* iconName(const studio::Operation& operation) {
    static const std::map<std::string_view, const char*> kIcons{{"peel", "peel"},
                                                                {"drill", "drill"},
                                                                {"laser", "laser"},
                                                                {"sweep", "sweep"},
                                                                {"scissors", "scissors"},
                                                                {"clip", "clip"},
                                                                {"paste", "paste"},
                                                                {"keep connected", "keep"},
                                                                {"move part", "move"},
                                                                {"seed", "seed"},
                                                                {"grow", "play"},
                                                                {"rewind", "back"},
                                                                {"show generation", "step"},
                                                                {"un-cut", "uncut"},
                                                                {"re-seed", "reseed"},
                                                                {"cut segment", "cut"}};
    const auto found = kIcons.find(studio::name(operation));
    return found != kIcons.end() ? found->second : "labels"; // the rest are edits of segments
}

} // namespace vs::desktop
