// SPDX-License-Identifier: Apache-2.0
#include "model/keepers/recent_documents.h"

#include "model/settings/settings.h"
#include "model/texts/library_texts.h"
#include "model/texts/texts.h"
#include "volume/reading/read_volume.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>
#include <array>

namespace vs::desktop {

namespace {

constexpr int kMost = 24; // as many as fill a few rows: older ones are found by the file dialog

void write(Settings& settings, const KnownDocument& document) {
    settings.setValue(document.isSession() ? "session" : "volume", document.path());
    settings.setValue("raw", QString::fromStdString(document.request.rawLayout));
    settings.setValue("series", QString::fromStdString(document.request.series));
    const auto setCount = [&](const char* key, std::optional<int> count) {
        settings.setValue(key, count ? QVariant(*count) : QVariant());
    };
    setCount("frame", document.request.frame);
    setCount("level", document.request.level);
    setCount("channel", document.request.channel);
    settings.setValue("details", document.details);
    settings.setValue("hasSegments", document.hasSegments);
    settings.setValue("seen", document.seen);
    settings.setValue("scan", textOf(document.scan));
}

KnownDocument read(const Settings& settings) {
    KnownDocument document;
    document.request.volume = settings.value("volume").toString().toStdString();
    document.request.session = settings.value("session").toString().toStdString();
    document.request.rawLayout = settings.value("raw").toString().toStdString();
    document.request.series = settings.value("series").toString().toStdString();
    const auto takeCount = [&](const char* key, std::optional<int>& count) {
        if (const QVariant value = settings.value(key); !value.toString().isEmpty()) {
            count = value.toInt();
        }
    };
    takeCount("frame", document.request.frame);
    takeCount("level", document.request.level);
    takeCount("channel", document.request.channel);
    document.details = settings.value("details").toString();
    document.hasSegments = settings.value("hasSegments").toBool();
    document.seen = settings.value("seen").toDateTime();
    document.scan = pathOf(settings.value("scan").toString());
    return document;
}

void writeAll(const std::vector<KnownDocument>& documents) {
    Settings settings;
    settings.remove("recent");
    settings.beginWriteArray("recent", int(documents.size()));
    for (int i = 0; i < int(documents.size()); ++i) {
        settings.setArrayIndex(i);
        write(settings, documents[std::size_t(i)]);
    }
    settings.endArray();
}

std::vector<KnownDocument> without(std::vector<KnownDocument> documents, const QString& key) {
    std::erase_if(documents, [&](const KnownDocument& other) { return other.key() == key; });
    return documents;
}

struct Example {
    const char* path; // below a folder of shared data
    const char* details;
};
// What is worth a look without knowing more about it.
constexpr std::array<Example, 4> kPackaged{
    {{"mricron/templates/ch2.nii.gz", QT_TRANSLATE_NOOP("library", "A head, magnetic resonance")},
     {"mricron/templates/ch2better.nii.gz", QT_TRANSLATE_NOOP("library", "The same head, sharper")},
     {"mricron/templates/ch2bet.nii.gz", QT_TRANSLATE_NOOP("library", "Its brain alone")},
     {"mricron/templates/inia19-t1-brain.nii.gz", QT_TRANSLATE_NOOP("library", "A macaque's brain")}}};

} // namespace

QString KnownDocument::path() const { return textOf(isSession() ? request.session : request.volume); }

QString KnownDocument::name() const {
    return title.isEmpty() ? QFileInfo(QDir::cleanPath(path())).fileName() : title;
}

bool KnownDocument::isMissing() const {
    return !request.given && !volume::isWebAddress(pathOf(path())) && !QFileInfo::exists(path());
}

QString KnownDocument::key() const {
    const auto text = [](std::optional<int> count) { return count ? QString::number(*count) : QString(); };
    QStringList parts{path(), QString::fromStdString(request.rawLayout),
                      QString::fromStdString(request.series), text(request.frame)};
    if (request.level || request.channel) { // others keep the keys that they had
        parts << text(request.level) << text(request.channel);
    }
    return parts.join('\n');
}

QString KnownDocument::picturePath() const {
    if (!picture.isEmpty()) {
        return picture;
    }
    const auto hash = QCryptographicHash::hash(key().toUtf8(), QCryptographicHash::Sha1).toHex();
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/pictures/" + hash + ".png";
}

std::vector<KnownDocument> recentDocuments() {
    Settings settings;
    std::vector<KnownDocument> documents;
    const int count = settings.beginReadArray("recent");
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        documents.push_back(read(settings));
    }
    std::erase_if(documents, [](const KnownDocument& document) { return document.path().isEmpty(); });
    return documents;
}

std::vector<std::filesystem::path> foldersUsedBefore() {
    std::vector<std::filesystem::path> folders;
    const auto add = [&](const std::filesystem::path& folder) {
        if (!folder.empty() && std::find(folders.begin(), folders.end(), folder) == folders.end()) {
            folders.push_back(folder);
        }
    };
    for (const KnownDocument& document : recentDocuments()) {
        add(pathOf(QDir::cleanPath(document.path())).parent_path());
        // A series is its folder, of which a slice may have been pointed out.
        add(document.scan.parent_path());
        add(document.scan.parent_path().parent_path());
    }
    return folders;
}

void rememberDocument(const KnownDocument& document) {
    auto documents = without(recentDocuments(), document.key());
    documents.insert(documents.begin(), document);
    for (; documents.size() > std::size_t(kMost); documents.pop_back()) {
        QFile::remove(documents.back().picturePath());
    }
    writeAll(documents);
}

void forgetDocument(const KnownDocument& document) {
    QFile::remove(document.picturePath());
    writeAll(without(recentDocuments(), document.key()));
}

std::vector<KnownDocument> exampleDocuments() {
    std::vector<KnownDocument> documents;
    for (const Example& example : kPackaged) {
        const QString found = QStandardPaths::locate(QStandardPaths::GenericDataLocation, example.path);
        if (!found.isEmpty()) {
            documents.push_back(
                {{found.toStdString(), {}, {}, {}, {}}, libraryText(example.details), false, {}});
        }
    }
    for (const QString& folder :
         QStandardPaths::locateAll(QStandardPaths::GenericDataLocation, "volume-studio/examples",
                                   QStandardPaths::LocateDirectory)) {
        QStringList names;
        for (QDirIterator it(folder, {"*.nii.gz", "*.nrrd", "*.mha", "*.json"}, QDir::Files); it.hasNext();) {
            names << it.next();
        }
        names.sort();
        for (const QString& name : names) {
            KnownDocument document;
            (name.endsWith(".json") ? document.request.session : document.request.volume) =
                name.toStdString();
            document.details = name.endsWith(".json") ? tr("A session to replay") : QString();
            documents.push_back(document);
        }
    }
    return documents;
}

} // namespace vs::desktop
