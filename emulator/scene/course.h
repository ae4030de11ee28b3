#pragma once

#include <vector>

namespace lds::emulator {

/// How a value runs along a workpiece: straight from point to point, constant before the first and after
/// the last. Two points at one position are a step; the second one is the value at the position itself.
class Course {
public:
    struct Point {
        double position;
        double value;
    };

    explicit Course(double constant);
    /// `points`: at least one, positions ascending.
    explicit Course(std::vector<Point> points);

    double valueAt(double position) const;
    double valueBefore(double position) const; ///< What the value runs to when coming from below.
    const std::vector<Point>& points() const { return m_points; }
    double end() const { return m_points.back().position; } ///< Where the last point is.
    /// The same once around a circle: the end runs into the beginning.
    Course closedAt(double circumference) const;

private:
    std::vector<Point> m_points;
};

/// A part of a workpiece in which height and reflectance run straight.
struct Facet {
    double from; ///< Position.
    double to;
    double heightFrom;
    double heightTo;
    double reflectanceFrom;
    double reflectanceTo;
};

/// The facets from position 0 to `length`, one behind the other without gaps.
std::vector<Facet> facetsOf(const Course& height, const Course& reflectance, double length);

} // namespace lds::emulator
