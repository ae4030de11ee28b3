#include "named_fault.h"

#include <algorithm>
#include <iterator>

namespace lds::emulator {

using namespace Qt::StringLiterals;

namespace {

struct FaultRow {
    NamedFault fault;
    QLatin1StringView key;
    std::optional<int> milliseconds = std::nullopt;
};

/// In the order of NamedFault, so that a fault is its own index.
constexpr FaultRow rows[] = {
    {NamedFault::NoLight, "noLight"_L1},
    {NamedFault::Saturated, "saturated"_L1},
    {NamedFault::AmbientLight, "ambientLight"_L1},
    {NamedFault::OutOfRange, "outOfRange"_L1},
    {NamedFault::LaserCircuitError, "laserCircuitError"_L1},
    {NamedFault::SystemError, "systemError"_L1},
    {NamedFault::SlowAnswers, "slowAnswers"_L1, 300},
    {NamedFault::AnswersLost, "answersLost"_L1},
    {NamedFault::AnswersCut, "answersCut"_L1},
    {NamedFault::ConnectionDropped, "connectionDropped"_L1},
    {NamedFault::InMenu, "inMenu"_L1},
    {NamedFault::Saving, "saving"_L1, 3000},
};

constexpr bool rowsAreInOrder()
{
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        if (std::size_t(rows[i].fault) != i)
            return false;
    }
    return std::size_t(NamedFault::Saving) + 1 == std::size(rows);
}
static_assert(rowsAreInOrder());

} // namespace

QString keyOf(NamedFault fault) { return rows[std::size_t(fault)].key; }

std::optional<NamedFault> faultNamed(const QString& key)
{
    const auto* const row =
        std::find_if(std::begin(rows), std::end(rows), [&](const FaultRow& each) { return each.key == key; });
    return row == std::end(rows) ? std::nullopt : std::optional(row->fault);
}

const QList<NamedFault>& allFaults()
{
    static const QList<NamedFault> faults = [] {
        QList<NamedFault> list;
        for (const FaultRow& row : rows)
            list.append(row.fault);
        return list;
    }();
    return faults;
}

std::optional<int> defaultMilliseconds(NamedFault fault) { return rows[std::size_t(fault)].milliseconds; }

} // namespace lds::emulator
