#pragma once

#include "keys.h"
#include "values.h"

#include <QStringList>
#include <tl/expected.hpp>

namespace lds::ctl {

/// KEY=VALUE as typed; the value is not read yet, since its limits depend on the sensor's type.
struct Assignment {
    Target target;
    QString text;
};

/// Refuses what cannot be set on any sensor: no “=”, an unknown or read-only key, a key set twice.
/// The error is a sentence for a person.
tl::expected<QList<Assignment>, QString> parseAssignments(const QStringList& arguments);

/// One item's value as the sensor will be sent it and as the sensor will keep it.
struct WantedValue {
    catalog::ItemId item;
    catalog::Value written;
    catalog::Value effective; ///< Digits below the resolution are rounded down (§1.4).
};

/// Reads the text for a sensor type: decimal text in the item's unit, a choice's code or its English name
/// (also without what it says in brackets; case does not matter), four numbers for an address.
tl::expected<QList<WantedValue>, QString> readValues(const Assignment& assignment,
                                                     catalog::SensorModel model);

} // namespace lds::ctl
