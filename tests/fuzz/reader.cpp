// SPDX-License-Identifier: Apache-2.0
// Reads volumes as the program does, one after the other, and says what became of each. Lines "PATH<tab>OUT"
// on standard input; for each a line of JSON: what was read, its values written to OUT, or why it was
// refused; and what it cost.
#include "base/error.h"
#include "volume/reading/read_volume.h"

#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <fstream>
#include <iostream>
#include <string>

namespace {

using Json = nlohmann::json;

double secondsOf(int who) {
    rusage usage{};
    getrusage(who, &usage);
    const auto seconds = [](const timeval& time) {
        return double(time.tv_sec) + 1e-6 * double(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double secondsOfAll() { return secondsOf(RUSAGE_SELF) + secondsOf(RUSAGE_CHILDREN); }

// Of the largest process so far, this one or a decoder.
double largestMegabytes() {
    double most = 0;
    for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        getrusage(who, &usage);
        most = std::max(most, double(usage.ru_maxrss) / 1024);
    }
    return most;
}

Json answerTo(const std::string& path, const std::string& out) {
    try {
        const auto result = vs::volume::readVolume(path);
        const auto& volume = result.volume;
        std::ofstream(out, std::ios::binary)
            .write(reinterpret_cast<const char*>(volume.bytes.data()), std::streamsize(volume.bytes.size()));
        Json matrix = Json::array();
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column) {
                matrix.push_back(volume.geometry.worldFromVoxel[column][row]);
            }
        }
        const auto dims = volume.geometry.dims;
        return {{"dims", {dims.x, dims.y, dims.z}},
                {"type", vs::volume::name(volume.type)},
                {"worldFromVoxel", matrix},
                {"notices", result.notices}};
    } catch (const vs::Error& error) {
        return {{"refused", error.what()}};
    }
}

} // namespace

int main() {
    std::string line;
    while (std::getline(std::cin, line)) {
        const auto tab = line.find('\t');
        const double before = secondsOfAll();
        Json answer = answerTo(line.substr(0, tab), line.substr(tab + 1));
        answer["seconds"] = secondsOfAll() - before;
        answer["megabytes"] = largestMegabytes();
        std::cout << answer.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
    }
    return 0;
}
