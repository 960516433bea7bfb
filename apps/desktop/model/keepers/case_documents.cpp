// SPDX-License-Identifier: Apache-2.0
#include "model/keepers/case_documents.h"

#include "studio/cases/cases.h"

#include <QCoreApplication>

#include <memory>

namespace vs::desktop {

namespace {

QString told(const std::string& text) { return QCoreApplication::translate("cases", text.c_str()); }

std::optional<KnownDocument> documentOf(const studio::Experiment& experiment) {
    for (const studio::Case& one : experiment.cases) {
        auto session = std::make_shared<studio::Session>(studio::sessionOf(one));
        if (session->isMade() || studio::findFile(session->volumePath, {})) {
            KnownDocument document;
            document.request.given = std::move(session);
            document.request.isPlayed = true;
            document.title = told(experiment.title);
            document.details = told(experiment.about);
            document.picture = QString(":/pictures/cases/%1.png").arg(QString::fromStdString(one.session));
            document.hasSegments = !one.compare.empty();
            return document;
        }
    }
    return {};
}

} // namespace

std::vector<KnownDocument> caseDocuments() {
    std::vector<KnownDocument> documents;
    for (const studio::Experiment& experiment : studio::caseIndex().experiments) {
        const bool isOfTheTen = experiment.thesis.has_value();
        if (auto document = isOfTheTen ? documentOf(experiment) : std::nullopt) {
            documents.push_back(std::move(*document));
        }
    }
    return documents;
}

} // namespace vs::desktop
