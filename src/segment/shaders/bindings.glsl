// Where programs of this module find their resources: the numbers of the bindings, for GLSL and C++ alike,
// which is why there is nothing else in here. Numbers of one kind that one program uses differ; programs that
// do not meet share them.

// Texture units.
const int kDataTexture = 0;
const int kSculptureTexture = 1;
const int kSegmentationTexture = 1;
const int kLabelTexture = 3;
const int kNewestTexelsTexture = 4;
const int kPagesTexture = 4;
const int kSculptureCellsTexture = 4;
const int kAllowedTexelsTexture = 5;
const int kGrownTexelsTexture = 6;

// Image units.
const int kLabelsImage = 0;
const int kSegmentationImage = 0;
const int kCellsImage = 1;

// Storage blocks.
const int kGrownStorage = 0;
const int kPointsStorage = 0;
const int kTilesStorage = 0;
const int kAddedStorage = 1;
const int kAllowedStorage = 1;
const int kAnswersStorage = 1;
const int kBrickNumbersStorage = 1;
const int kKindsStorage = 1;
const int kPlaneStorage = 1;
const int kRegionStorage = 1;
const int kRowsStorage = 1;
const int kRulesOfLabelsStorage = 1;
const int kTableStorage = 1;
const int kAlongXYStorage = 2;
const int kForbiddenToSeedStorage = 2;
const int kFoundStorage = 2;
const int kGainsStorage = 2;
const int kLossesStorage = 2;
const int kMadePlaneStorage = 2;
const int kNewestStorage = 2;
const int kShownBitsStorage = 2;
const int kGenerationsStorage = 3;
const int kShownStorage = 3;
const int kLateGenerationsStorage = 4;
const int kTurnedStorage = 4;
const int kLabelsOfTilesStorage = 5;
const int kReachStorage = 5;
const int kExpansionsStorage = 5;
const int kForbiddenInPlaneStorage = 6;
const int kOwnersStorage = 6;
const int kPagesOfTilesStorage = 6;
const int kTurnedBitsStorage = 6;
const int kWorkStorage = 6;
const int kBricksStorage = 7;
const int kForbiddenToGrowStorage = 7;
const int kNumbersStorage = 7;
const int kVoxelsStorage = 7;
