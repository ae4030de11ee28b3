#include "course.h"

#include <algorithm>
#include <utility>

namespace lds::emulator {

namespace {

double between(const Course::Point& left, const Course::Point& right, double position)
{
    const double share = (position - left.position) / (right.position - left.position);
    return left.value + share * (right.value - left.value);
}

} // namespace

Course::Course(double constant)
    : m_points{{0.0, constant}}
{}

Course::Course(std::vector<Point> points)
    : m_points(std::move(points))
{}

double Course::valueAt(double position) const
{
    const auto next = std::upper_bound(m_points.begin(), m_points.end(), position,
                                       [](double at, const Point& point) { return at < point.position; });
    if (next == m_points.begin())
        return next->value;
    const Point& previous = *std::prev(next);
    return next == m_points.end() ? previous.value : between(previous, *next, position);
}

double Course::valueBefore(double position) const
{
    const auto next = std::lower_bound(m_points.begin(), m_points.end(), position,
                                       [](const Point& point, double at) { return point.position < at; });
    if (next == m_points.begin())
        return next->value;
    const Point& previous = *std::prev(next);
    return next == m_points.end() ? previous.value : between(previous, *next, position);
}

Course Course::closedAt(double circumference) const
{
    const Point& first = m_points.front();
    const Point& last = m_points.back();
    if (first.position <= 0 && last.position >= circumference)
        return *this;
    // Where the line from the last point to the first one of the next turn crosses the seam.
    const double seam = between(last, {first.position + circumference, first.value}, circumference);
    std::vector<Point> closed;
    closed.reserve(m_points.size() + 2);
    if (first.position > 0)
        closed.push_back({0, seam});
    closed.insert(closed.end(), m_points.begin(), m_points.end());
    if (last.position < circumference)
        closed.push_back({circumference, seam});
    return Course(std::move(closed));
}

std::vector<Facet> facetsOf(const Course& height, const Course& reflectance, double length)
{
    std::vector<double> edges{0.0, length};
    for (const Course* course : {&height, &reflectance}) {
        for (const Course::Point& point : course->points()) {
            if (point.position > 0 && point.position < length)
                edges.push_back(point.position);
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

    std::vector<Facet> facets;
    facets.reserve(edges.size());
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        const double from = edges[i];
        const double to = edges[i + 1];
        facets.push_back({from, to, height.valueAt(from), height.valueBefore(to), reflectance.valueAt(from),
                          reflectance.valueBefore(to)});
    }
    return facets;
}

} // namespace lds::emulator
