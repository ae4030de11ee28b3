#pragma once

#include "json_fields.h"
#include "scene_description.h"
#include "scene_reader.h"

namespace lds::emulator {

/// The unit that a scene's heights are written in.
struct HeightUnit {
    double nanometres = 1'000'000; ///< of 1
    double most = 0;               ///< of a height
    const char* text = " mm";
    NumberLimits signedLimits() const { return {-most, most, text}; }
    NumberLimits unsignedLimits() const { return {0, most, text}; }
};

inline constexpr NumberLimits lightLimits{0, mostLight};

/// How the positions of workpieces are meant, which their own reading has to know first.
bool turnsOnShaft(const QJsonObject& scene);

/// Reads the field "motion", whose workpieces are the ones given.
Motion readMotion(const QJsonValue& value, const std::vector<WorkpieceDescription>& workpieces,
                  const HeightUnit& unit, Complaint& complaint);

/// atMs, forMs and everyMs of an element.
Interval readInterval(JsonFields& fields);
/// The same of something that has a duration of its own: atMs and everyMs only.
Interval readInterval(JsonFields& fields, qint64 durationMs);

} // namespace lds::emulator
