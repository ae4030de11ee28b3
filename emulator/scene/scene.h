#pragma once

#include "catalog.h"
#include "interval.h"
#include "named_fault.h"
#include "scenery.h"

#include <memory>
#include <QByteArray>
#include <QList>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

namespace lds::emulator {

struct ScheduledFault {
    NamedFault fault;
    Interval when;
    int milliseconds = 0; ///< Of slowAnswers and saving; saving is on for just as long.
};

/// What a virtual sensor looks at, from a small JSON file (docs/scenes.md). Immutable.
class Scene final : public Scenery {
public:
    ~Scene() override;

    QString name() const;
    QString description() const;
    QStringList workpieces() const; ///< Their names, in the order of the file.
    Sight at(qint64 timeNs) const override;
    /// The workpiece standing still with its measuring point under the beam, in the same light and noise;
    /// nothing for a name that is none of workpieces().
    std::shared_ptr<const Scenery> holdingStill(const QString& workpiece) const;
    const QList<ScheduledFault>& faults() const;
    const QList<Interval>& triggers() const; ///< When the trigger input line is ON.

    /// The error names line or field; `model` decides what the measurement range is.
    static tl::expected<std::shared_ptr<const Scene>, QString> fromJson(const QByteArray& json,
                                                                        catalog::SensorModel model);
    /// The same from a file, or from one of examples() by its key; the error names the file too.
    static tl::expected<std::shared_ptr<const Scene>, QString> load(const QString& pathOrExample,
                                                                    catalog::SensorModel model);
    /// Keys of the scenes that come with the program ("conveyor-step", …).
    static QStringList examples();

private:
    struct Parts;
    explicit Scene(std::shared_ptr<const Parts> parts);
    std::shared_ptr<const Parts> m_parts;
};

} // namespace lds::emulator
