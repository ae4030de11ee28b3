#pragma once

#include "keys.h"
#include "session_types.h"
#include "values.h"

#include <QJsonObject>
#include <QList>

namespace lds::ctl {

/// What became of one KEY=VALUE.
enum class SetStatus : quint8 {
    NotTried,  ///< Something before it failed, or there is no order of writes.
    Unchanged, ///< The sensor held it already: nothing was written.
    Done,      ///< Written and read back, or carried out.
    Different, ///< Accepted, but the sensor holds another value.
    Refused,
    Unknown, ///< No answer: it may or may not have been carried out. It is not repeated.
};

struct SetResult {
    Target target;
    settings::Values wanted; ///< What the sensor should hold, by item of the target.
    settings::Values before;
    SetStatus status = SetStatus::NotTried;
};

/// Collects what became of every KEY=VALUE of a command line and puts it into words.
class SetReport {
public:
    void add(const SetResult& result) { m_results.append(result); }
    /// What the sensor held when the item's turn came: a bank switched before it changes that.
    void noteBefore(catalog::ItemId item, const settings::Values& held);
    /// Sets the status of the result that the item belongs to. The worst of a group's items stands.
    void mark(catalog::ItemId item, SetStatus status);
    /// The settings that go out together, marked by how their apply went. `asked` are the items that
    /// differed from what the sensor held.
    void markApplied(const sensor::ApplyReport& report, const QList<catalog::ItemId>& asked);

    const QList<SetResult>& results() const { return m_results; }
    bool wroteASetting() const;

    QJsonObject toJson(catalog::SensorModel model, const settings::Values& held, sensor::Saved saved) const;
    QStringList toLines(catalog::SensorModel model, const settings::Values& held) const;

private:
    SetResult* find(catalog::ItemId item);

    QList<SetResult> m_results;
};

} // namespace lds::ctl
