// SPDX-License-Identifier: Apache-2.0
#include "window/options.h"

#include "model/texts/texts.h"

#include "base/error.h"

#include <QCommandLineParser>
#include <QCoreApplication>

#include <optional>

namespace vs::desktop {

namespace {

// A number from 0 on; nothing where the option is not given.
std::optional<int> countOf(const QCommandLineParser& parser, const QCommandLineOption& option) {
    if (!parser.isSet(option)) {
        return {};
    }
    bool isNumber = false;
    const int count = parser.value(option).toInt(&isNumber);
    if (!isNumber) {
        throw UsageError("--{} {} is not a number; give 0, 1 ...", option.names().first().toStdString(),
                         parser.value(option).toStdString());
    }
    return count;
}

} // namespace

Options parseOptions(const QCoreApplication& application) {
    QCommandLineParser parser;
    parser.setApplicationDescription(tr("Reshape a 3D scan with a pen, on the rendered picture itself."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        "file", tr("Volume to open (a file or a DICOM folder), or a session (.json)."), "[FILE]");
    const QCommandLineOption session(
        "session", tr("Session to open and replay; FILE, if given, replaces its volume."), "SESSION.json");
    const QCommandLineOption raw("raw", tr("FILE has no header: DIMS:TYPE[:SPACING[:OFFSET]]."), "LAYOUT");
    const QCommandLineOption series("series", tr("Which DICOM series of a folder: its UID or its number."),
                                    "SERIES");
    const QCommandLineOption frame("frame", tr("Which volume of a 4D file, counted from 0."), "N");
    const QCommandLineOption level("level", tr("Which level of a store of OME-Zarr; 0 is the finest."), "N");
    const QCommandLineOption channel("channel", tr("Which channel of a store, counted from 0."), "N");
    const QCommandLineOption deviceMemory(
        "device-memory", tr("What volumes and edits may take on the device, for example 512MiB or 4GiB."),
        "AMOUNT");
    const QCommandLineOption memory("memory", tr("What they may take on the host, likewise."), "AMOUNT");
    const QCommandLineOption layout(
        "layout-file",
        tr("For tests and automation: keep PATH up to date with a JSON object of the program's state "
           "(\"idle\", "
           "\"tool\", \"mode\", \"generation\", \"voxels\", \"operations\", \"message\", \"pictureComplete\" "
           "...) and the "
           "rectangle [x, y, width, height] of the picture (\"viewRect\") and of each named button and field "
           "(\"widgets\") in pixels of the screen. It is replaced as a whole whenever something changes."),
        "PATH");
    const QCommandLineOption timings(
        "timings-file",
        tr("When the program ends, write to PATH as JSON when each input arrived and was handled and shown "
           "(\"inputs\"), when each picture was shown (\"frames\") and what kept the window from anything "
           "else for "
           "more than 40 ms (\"blocks\"), in milliseconds."),
        "PATH");
    parser.addOptions({session, raw, series, frame, level, channel, deviceMemory, memory, layout, timings});
    parser.process(application);

    Options options;
    const QStringList files = parser.positionalArguments();
    if (files.size() > 1) {
        throw UsageError("one file can be opened at a time, {} were given", files.size());
    }
    if (!files.isEmpty()) {
        options.open.volume = pathOf(files.front());
        if (files.front().endsWith(".json", Qt::CaseInsensitive) && !parser.isSet(session)) {
            options.open.session = std::exchange(options.open.volume, {});
        }
    }
    if (parser.isSet(session)) {
        options.open.session = pathOf(parser.value(session));
    }
    options.open.rawLayout = parser.value(raw).toStdString();
    options.open.series = parser.value(series).toStdString();
    options.open.frame = countOf(parser, frame);
    options.open.level = countOf(parser, level);
    options.open.channel = countOf(parser, channel);
    const auto amountOf = [&](const QCommandLineOption& option) {
        const std::string name = "--" + option.names().first().toStdString();
        return parser.isSet(option) ? studio::memoryOf(parser.value(option).toStdString(), name) : 0;
    };
    options.budgets = {amountOf(deviceMemory), amountOf(memory)};
    options.layoutFile = pathOf(parser.value(layout));
    options.timingsFile = pathOf(parser.value(timings));
    return options;
}

} // namespace vs::desktop
