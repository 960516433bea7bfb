// SPDX-License-Identifier: Apache-2.0
#include "arguments/volume_argument.h"

#include "reports/progress.h"

#include "base/log.h"
#include "volume/reading/read_volume.h"

namespace vs::cli {

std::shared_ptr<VolumeArgument> addVolumeArgument(CLI::App& command) {
    auto argument = std::make_shared<VolumeArgument>();
    command
        .add_option(
            "VOLUME", argument->path,
            "NIfTI, NRRD, MetaImage or VTK legacy file, DICOM folder or one of its files, TIFF stack or "
            "folder of TIFF files, store of OME-Zarr, or a raw file")
        ->required();
    addReadOptions(command, *argument);
    return argument;
}

void addReadOptions(CLI::App& command, VolumeArgument& argument, const char* level) {
    command.add_option("--raw", argument.rawLayout,
                       "Layout of a headerless little-endian file, DIMS:TYPE[:SPACING[:OFFSET]], for example "
                       "256x256x108:int16:0.957,0.957,1.5");
    command.add_option("--series", argument.series,
                       "DICOM series to read: its number in the list of choices or UID");
    command.add_option("--frame", argument.frame, "Which volume of a 4D file to read, counted from 0");
    command.add_option(level, argument.level, "Which level of a store to read; 0, the finest, without");
    command.add_option("--channel", argument.channel, "Which channel of a store to read, counted from 0");
}

volume::ReadOptions readOptions(const VolumeArgument& argument) {
    volume::ReadOptions options;
    if (argument.rawLayout) {
        options.raw = volume::parseRawLayout(*argument.rawLayout);
    }
    options.series = argument.series;
    options.frame = argument.frame;
    options.level = argument.level;
    options.channel = argument.channel;
    return options;
}

volume::ReadResult loadVolume(const VolumeArgument& argument) {
    auto result = [&] {
        const Activity activity("reading " + argument.path);
        return volume::readVolume(argument.path, readOptions(argument));
    }();
    for (const auto& notice : result.notices) {
        logNotice(notice);
    }
    return result;
}

} // namespace vs::cli
