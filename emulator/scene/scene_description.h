#pragma once

#include "course.h"
#include "interval.h"
#include "scene.h"
#include "surroundings.h"

#include <optional>
#include <QList>
#include <QString>
#include <variant>
#include <vector>

namespace lds::emulator {

inline constexpr double fullTurn = 360.0; ///< Degrees.

/// A workpiece as the file describes it. Positions in mm along the movement, or in degrees on a shaft.
struct WorkpieceDescription {
    QString name;
    Course height;      ///< nm from the measurement centre, towards the sensor positive.
    Course reflectance; ///< See Sight.
    double length;      ///< mm; 360 on a shaft; 0 where nothing says how long it is.
    double measuringPoint;
};

/// What lies behind or between the workpieces; nothing at all unless a scene has one.
struct Background {
    double height; ///< nm
    double reflectance;
};

/// Index into SceneDescription::workpieces; nothing for an empty place.
using Place = std::optional<std::size_t>;

struct ConveyorMotion {
    double speed; ///< mm/s
    std::vector<Place> order;
    std::optional<double> pitch; ///< mm from start to start; otherwise `gap` from end to start.
    double gap;
    std::optional<Background> background;
};
struct ShaftMotion {
    std::size_t workpiece;
    double revolutionsPerSecond;
    double eccentricity; ///< nm; 0° is the side that stands out.
};
struct PlateMotion {
    std::size_t workpiece;
    double amplitude; ///< nm
    double frequency; ///< Hz
};
struct StillMotion {
    std::size_t workpiece;
};
struct TimelineMotion {
    struct Placing {
        Place workpiece;
        qint64 atMs;
    };
    std::vector<Placing> places; ///< Ascending in time.
    qint64 repeatMs;             ///< 0: the last one stays.
    std::optional<Background> background;
};
using Motion = std::variant<ConveyorMotion, ShaftMotion, PlateMotion, StillMotion, TimelineMotion>;

/// A scene file, checked, with all heights in nanometres.
struct SceneDescription {
    QString name;
    QString description;
    std::vector<WorkpieceDescription> workpieces;
    Motion motion;
    Surroundings surroundings;
    QList<ScheduledFault> faults;
    QList<Interval> triggers;
};

} // namespace lds::emulator
