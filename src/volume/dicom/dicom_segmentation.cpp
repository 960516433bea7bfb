// SPDX-License-Identifier: Apache-2.0
#include "volume/dicom/dicom_segmentation.h"

#include "base/error.h"
#include "volume/dicom/dcmtk_log.h"

#include <dcmtk/config/osconfig.h> // DCMTK wants it first

#include <dcmtk/dcmdata/dcostrmb.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmfg/fgderimg.h>
#include <dcmtk/dcmfg/fgfracon.h>
#include <dcmtk/dcmfg/fgpixmsr.h>
#include <dcmtk/dcmfg/fgplanor.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmiod/cielabutil.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace vs::volume {

namespace {

void need(const OFCondition& condition) {
    if (condition.bad()) {
        throw std::runtime_error(condition.text());
    }
}

// A decimal string has 16 characters at most.
OFString decimal(double value) { return fmt::format("{:.9g}", value == 0 ? 0.0 : value).c_str(); }

OFString freshUid() {
    char uid[100];
    return dcmGenerateUniqueIdentifier(uid, SITE_INSTANCE_UID_ROOT);
}

// A file of the series that the grid was read from: its header.
struct Source {
    std::unique_ptr<DcmFileFormat> file;
    glm::dvec3 position{0};
    bool isOneSlice = false; // that says which it is, and where it lies
};

Source readSource(const std::filesystem::path& path) {
    Source source{std::make_unique<DcmFileFormat>()};
    need(source.file->loadFileUntilTag(path.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength,
                                       ERM_autoDetect, DCM_PixelData));
    DcmDataset& data = *source.file->getDataset();
    const auto hasUid = [&data](const DcmTagKey& tag) {
        constexpr std::size_t most = 64;
        OFString uid;
        return data.findAndGetOFString(tag, uid).good() && !uid.empty() && uid.size() <= most;
    };
    Sint32 frames = 1;
    const bool isMultiFrame = data.findAndGetSint32(DCM_NumberOfFrames, frames).good() && frames > 1;
    source.isOneSlice = !isMultiFrame && hasUid(DCM_SOPClassUID) && hasUid(DCM_SOPInstanceUID);
    for (int axis = 0; axis < 3; ++axis) {
        Float64 value = 0;
        source.isOneSlice =
            source.isOneSlice &&
            data.findAndGetFloat64(DCM_ImagePositionPatient, value, static_cast<unsigned long>(axis)).good();
        source.position[axis] = value;
    }
    return source;
}

// Makes one DICOM Segmentation object.
class SegmentationFile {
public:
    SegmentationFile(const GridGeometry& geometry, std::span<const std::filesystem::path> sources)
        : geometry_(geometry) {
        for (const auto& path : sources) {
            sources_.push_back(readSource(path));
        }
        const IODGeneralEquipmentModule::EquipmentInfo equipment("Volume Studio", "Volume Studio", "0",
                                                                 "0.1");
        const ContentIdentificationMacro content("1", "SEGMENTATION", "Segments of Volume Studio",
                                                 "Volume Studio");
        DcmSegmentation* made = nullptr;
        need(DcmSegmentation::createBinarySegmentation(made, Uint16(geometry.dims.y), Uint16(geometry.dims.x),
                                                       equipment, content));
        file_.reset(made);
        takeOrigin();
        describeGrid();
    }

    void add(const DicomSegment& segment, std::span<const std::uint8_t> labels) {
        const CodeSequenceMacro tissue("85756007", "SCT", "Tissue");
        DcmSegment* made = nullptr;
        need(DcmSegment::create(made, readable(segment.name), tissue, tissue, DcmSegTypes::SAT_SEMIAUTOMATIC,
                                "Volume Studio"));
        double l = 0;
        double a = 0;
        double b = 0;
        IODCIELabUtil::rgb2DicomLab(l, a, b, segment.colour.r, segment.colour.g, segment.colour.b);
        need(made->setRecommendedDisplayCIELabValue(Uint16(std::lround(l)), Uint16(std::lround(a)),
                                                    Uint16(std::lround(b))));
        Uint16 number = 0;
        need(file_->addSegment(made, number));
        const std::size_t slice = std::size_t(geometry_.dims.x) * std::size_t(geometry_.dims.y);
        for (int k = 0; k < geometry_.dims.z; ++k) {
            const auto values = labels.subspan(std::size_t(k) * slice, slice);
            std::vector<Uint8> frame(slice);
            std::transform(values.begin(), values.end(), frame.begin(),
                           [&](std::uint8_t value) { return Uint8(value == segment.label ? 1 : 0); });
            if (std::find(frame.begin(), frame.end(), 1) != frame.end()) {
                addFrame(frame, number, k);
            }
        }
    }

    // The bytes of its file, piece by piece.
    void save(const std::function<void(std::span<const std::byte>)>& take) {
        constexpr E_TransferSyntax syntax = EXS_LittleEndianExplicit;
        DcmFileFormat file;
        need(file_->writeDataset(*file.getDataset()));
        need(file.validateMetaInfo(syntax));
        std::vector<char> room(std::size_t(1) << 20U);
        DcmOutputBufferStream stream(room.data(), offile_off_t(room.size()));
        file.transferInit();
        OFCondition condition = EC_StreamNotifyClient; // says that the room is full
        while (condition == EC_StreamNotifyClient) {
            condition = file.write(stream, syntax, EET_ExplicitLength, nullptr);
            void* bytes = nullptr;
            offile_off_t length = 0;
            stream.flushBuffer(bytes, length);
            take({static_cast<const std::byte*>(bytes), std::size_t(length)});
        }
        file.transferEnd();
        need(condition);
    }

private:
    void takeOrigin() {
        need(file_->getSeries().setSeriesNumber("1"));
        need(file_->getSeries().setSeriesDescription("Segments of Volume Studio"));
        if (sources_.empty()) {
            need(file_->getFrameOfReference().setFrameOfReferenceUID(freshUid()));
            need(file_->getSOPCommon().setSpecificCharacterSet("ISO_IR 192"));
            return;
        }
        // What is missing there is made up.
        const auto& first = *sources_.front().file;
        need(file_->importHierarchy(*const_cast<DcmFileFormat&>(first).getDataset(), OFTrue, OFTrue, OFTrue,
                                    OFFalse, OFTrue));
        OFString frameOfReference;
        (void)file_->getFrameOfReference().getFrameOfReferenceUID(frameOfReference);
        if (frameOfReference.empty()) {
            need(file_->getFrameOfReference().setFrameOfReferenceUID(freshUid()));
        }
        nameSeries();
    }

    // Names the whole series, so that viewers find it.
    void nameSeries() {
        IODReferences series;
        for (const Source& source : sources_) {
            DcmDataset& data = *source.file->getDataset();
            const auto text = [&data](const DcmTagKey& tag) {
                OFString value;
                (void)data.findAndGetOFString(tag, value);
                return value;
            };
            const OFString study = text(DCM_StudyInstanceUID);
            const OFString uid = text(DCM_SeriesInstanceUID);
            if (source.isOneSlice && !study.empty() && !uid.empty()) {
                series.add(new IODImageReference(text(DCM_PatientID), study, uid, text(DCM_SOPClassUID),
                                                 text(DCM_SOPInstanceUID))); // which takes it over
            }
        }
        if (series.size() > 0) {
            OFString own;
            (void)file_->getStudy().getStudyInstanceUID(own);
            file_->getCommonInstanceReference().addReferences(series, own);
        }
    }

    // Texts are in the character set that the patient's name is in.
    OFString readable(const std::string& name) const {
        OFString set;
        (void)file_->getSOPCommon().getSpecificCharacterSet(set);
        std::string text = name.empty() ? "Segment" : name;
        if (set != "ISO_IR 192") {
            std::replace_if(
                text.begin(), text.end(), [](unsigned char c) { return c > 126 || c < ' '; }, '_');
        }
        std::replace(text.begin(), text.end(), '\\', '_'); // parts values
        constexpr std::size_t most = 64;
        std::size_t length = std::min(text.size(), most);
        while (length > 0 && length < text.size() && (text[length] & 0xC0) == 0x80) {
            --length; // not within a character
        }
        return text.substr(0, length).c_str();
    }

    void describeGrid() {
        const glm::dvec3 spacing = geometry_.spacing();
        FGPixelMeasures measures;
        need(measures.setPixelSpacing(decimal(spacing.y) + "\\" + decimal(spacing.x)));
        need(measures.setSliceThickness(decimal(spacing.z)));
        need(measures.setSpacingBetweenSlices(decimal(spacing.z)));
        const auto along = [&](int axis) {
            return glm::dvec3(geometry_.worldFromVoxel[axis]) / spacing[axis];
        };
        const glm::dvec3 row = along(0);
        const glm::dvec3 column = along(1);
        const std::unique_ptr<FGPlaneOrientationPatient> orientation(FGPlaneOrientationPatient::createMinimal(
            decimal(row.x), decimal(row.y), decimal(row.z), decimal(column.x), decimal(column.y),
            decimal(column.z)));
        need(file_->addForAllFrames(measures));
        need(file_->addForAllFrames(*orientation));
        const OFString uid = freshUid();
        auto& dimensions = file_->getDimensions();
        need(dimensions.addDimensionIndex(DCM_ReferencedSegmentNumber, uid, DCM_SegmentIdentificationSequence,
                                          "Segment"));
        need(dimensions.addDimensionIndex(DCM_ImagePositionPatient, uid, DCM_PlanePositionSequence,
                                          "Position"));
    }

    void addFrame(std::vector<Uint8>& pixels, Uint16 segment, int slice) {
        const glm::dvec3 place(geometry_.worldFromVoxel * glm::dvec4(0, 0, slice, 1));
        const std::unique_ptr<FGPlanePosPatient> position(
            FGPlanePosPatient::createMinimal(decimal(place.x), decimal(place.y), decimal(place.z)));
        FGFrameContent content;
        need(content.setDimensionIndexValues(segment, 0));
        need(content.setDimensionIndexValues(Uint32(slice + 1), 1));
        OFVector<FGBase*> groups;
        groups.push_back(position.get());
        groups.push_back(&content);
        FGDerivationImage derivation;
        if (nameSource(derivation, place)) {
            groups.push_back(&derivation);
        }
        need(file_->addFrame(pixels.data(), segment, groups));
    }

    // Names the image that lies where the frame does, if there is one.
    bool nameSource(FGDerivationImage& derivation, glm::dvec3 place) {
        const double near = 0.01 * geometry_.stepMm();
        const auto source = std::find_if(sources_.begin(), sources_.end(), [&](const Source& one) {
            return one.isOneSlice && glm::distance(one.position, place) < near;
        });
        if (source == sources_.end()) {
            return false;
        }
        DerivationImageItem* item = nullptr;
        need(derivation.addDerivationImageItem(CodeSequenceMacro("113076", "DCM", "Segmentation"), "", item));
        SourceImageItem* image = nullptr;
        need(item->addSourceImageItem(
            source->file->getDataset(),
            CodeSequenceMacro("121322", "DCM", "Source image for image processing operation"), image));
        return true;
    }

    const GridGeometry& geometry_;
    std::vector<Source> sources_;
    std::unique_ptr<DcmSegmentation> file_;
};

} // namespace

int makeDicomSegmentation(const SegmentationOrder& order, std::span<const std::uint8_t> labels,
                          const std::function<void(std::span<const std::byte>)>& take) {
    silenceDcmtk();
    const auto sources = order.source.empty() ? std::vector<std::filesystem::path>()
                                              : dicomFilesOf(order.source, order.reading);
    SegmentationFile file(order.geometry, sources);
    for (const DicomSegment& segment : order.segments) {
        file.add(segment, labels);
    }
    file.save(take);
    return int(sources.size());
}

} // namespace vs::volume
