#pragma once

#include "fake_link.h"
#include "manual_scheduler.h"
#include "sensor_session.h"
#include "settings_model.h"
#include "theme.h"

#include <memory>
#include <QApplication>
#include <QtTest>

namespace lds::ui {

using catalog::ItemId;
using catalog::Value;

/// A session on a fake sensor, ready, for models and pages; time stands still unless a test moves it.
class SensorFixture {
public:
    explicit SensorFixture(catalog::SensorModel model = catalog::SensorModel::HlG203, bool viewOnly = false)
    {
        ports::registerMetaTypes();
        url.host = QStringLiteral("127.0.0.1");
        url.sensor = model;
        url.viewOnly = viewOnly;
        session = std::make_unique<sensor::SensorSession>(url, links, scheduler);
    }
    ~SensorFixture()
    {
        session.reset();
        support::settle();
    }
    SensorFixture(const SensorFixture&) = delete;
    SensorFixture& operator=(const SensorFixture&) = delete;

    support::FakeSensor& sensor() { return links.sensor(url); }

    void open()
    {
        session->open();
        support::settle();
        QCOMPARE(session->connection(), sensor::Connection::Ready);
    }
    /// Somebody else changes a value, and the session notices.
    void changeElsewhere(ItemId item, Value value)
    {
        sensor().set(item, value);
        session->readAll();
        support::settle();
        QCOMPARE(session->held(item), std::optional<Value>(value));
    }
    void cut()
    {
        sensor().failOpenings(ports::OpenFailure::Refused);
        sensor().cut();
        support::settle();
        QVERIFY(session->isStale());
    }
    std::optional<Value> wanted(ItemId item) const
    {
        const auto edit = session->pending().find(item);
        return edit ? std::optional<Value>(edit->wanted) : std::nullopt;
    }

    ports::ManualScheduler scheduler;
    support::FakeLinkFactory links{scheduler};
    ports::ConnectionUrl url;
    std::unique_ptr<sensor::SensorSession> session;
};

inline QString cell(const SettingsModel& model, ItemId item, int column, int role = Qt::DisplayRole)
{
    return model.indexOf(item, column).data(role).toString();
}
inline SettingsModel::RowStates statesOf(const SettingsModel& model, ItemId item)
{
    return SettingsModel::RowStates(model.indexOf(item).data(SettingsModel::StateRole).toInt());
}

} // namespace lds::ui
