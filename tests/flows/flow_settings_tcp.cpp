#include "bank_buttons.h"
#include "demo_sensor.h"
#include "modbus_link_factory.h"
#include "qt_scheduler.h"
#include "settings_model.h"
#include "settings_page.h"
#include "settings_view.h"
#include "theme.h"

#include <memory>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>
#include <QVBoxLayout>

using namespace lds;
using namespace lds::ui;
using catalog::ItemId;
using catalog::Value;
using emulator::SensorStation;

namespace {

class NoFrameLog final : public ports::FrameLog {
public:
    void record(const ports::Frame&) override {}
};

} // namespace

/// The settings page on a real link to a virtual sensor on a real socket.
class SettingsTcpFlow : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void everyReachableRowShowsWhatTheSensorHolds();
    void whatIsTypedIsAppliedAndThenNoLongerPending();
    void anAddressGoesOutAsOneChange();
    void aBankSwitchShowsTheOtherBanksValues();
    void whatTheKeypadChangesIsSeenWhileAnEditorIsOpen();
    void aCutLeavesTheLastKnownValuesMarked();

private:
    SettingsModel& model() const { return *m_page->findChild<SettingsModel*>(); }
    QString shown(ItemId item, int column) const { return model().indexOf(item, column).data().toString(); }
    Value holds(ItemId item) const
    {
        return m_device->ask(
            [item](SensorStation& station) { return station.sensor().memory().value(item); });
    }
    static void type(const QString& text)
    {
        for (const QChar c : text)
            QTest::keyClick(QApplication::focusWidget(), c.toLatin1());
    }
    static void press(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }

    NoFrameLog m_log;
    ports::QtScheduler m_scheduler;
    std::unique_ptr<emulator::DemoSensor> m_device;
    std::unique_ptr<modbus::ModbusLinkFactory> m_links;
    std::unique_ptr<sensor::SensorSession> m_session;
    std::unique_ptr<QWidget> m_window;
    SettingsPage* m_page = nullptr;
    SettingsView* m_view = nullptr;
};

void SettingsTcpFlow::initTestCase()
{
    ports::registerMetaTypes();
    Theme::instance().apply(*qApp, ThemeMode::Light);
}

void SettingsTcpFlow::init()
{
    m_device = std::make_unique<emulator::DemoSensor>(catalog::SensorModel::HlG205);
    QSignalSpy ready(m_device.get(), &emulator::DemoSensor::ready);
    m_device->start();
    QTRY_VERIFY(m_device->port() != 0);
    ports::ConnectionUrl url;
    url.host = QStringLiteral("127.0.0.1");
    url.port = m_device->port();
    url.sensor = catalog::SensorModel::HlG205;
    m_links = std::make_unique<modbus::ModbusLinkFactory>(m_log);
    m_session = std::make_unique<sensor::SensorSession>(url, *m_links, m_scheduler);
    sensor::SensorSession::Timing timing;
    timing.walkIntervalMs = 20;
    m_session->setTiming(timing);
    m_window = std::make_unique<QWidget>();
    auto* layout = new QVBoxLayout(m_window.get());
    m_page = new SettingsPage(m_window.get());
    layout->addWidget(m_page);
    m_window->resize(1180, 700);
    m_page->setSession(m_session.get());
    m_view = m_page->findChild<SettingsView*>();
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_view->setFocus();
    m_session->open();
    QTRY_COMPARE(m_session->connection(), sensor::Connection::Ready);
}

void SettingsTcpFlow::cleanup()
{
    m_window.reset();
    m_session.reset();
    m_links.reset();
    m_device.reset();
}

void SettingsTcpFlow::everyReachableRowShowsWhatTheSensorHolds()
{
    int compared = 0;
    for (const SettingRow* row : model().tree()->all()) {
        if (!row->isSetting() || row->shape != SettingRow::Shape::Single || !row->first()->modbus)
            continue;
        const ItemId id = row->first()->id;
        QCOMPARE(m_session->held(id), std::optional<Value>(holds(id)));
        QVERIFY2(!shown(id, SettingsModel::InSensor).isEmpty(), row->first()->key);
        ++compared;
    }
    QVERIFY(compared > 25);
    QCOMPARE(shown(ItemId::IpAddress1stOctet, SettingsModel::InSensor), QStringLiteral("192.168.1.6"));
    QCOMPARE(shown(ItemId::PortSlmp, SettingsModel::InSensor), QStringLiteral("not reachable over Modbus"));
}

void SettingsTcpFlow::whatIsTypedIsAppliedAndThenNoLongerPending()
{
    m_page->showItem(ItemId::HighSetValue);
    type(QStringLiteral("1.7509")); // this type keeps 1 µm
    press(Qt::Key_Return);
    type(QStringLiteral("0,75")); // LOW comes next, and a comma will do
    press(Qt::Key_Return);
    QVERIFY(m_page->finishEditing());
    QVERIFY(m_session->apply());
    QTRY_VERIFY(m_session->pending().isEmpty());
    QCOMPARE(holds(ItemId::HighSetValue), 17500);
    QCOMPARE(holds(ItemId::LowSetValue), 7500);
    QCOMPARE(shown(ItemId::HighSetValue, SettingsModel::InSensor), QStringLiteral("+1.750"));
    QVERIFY(!model().states(*model().tree()->find(ItemId::HighSetValue)).testFlag(SettingsModel::Edited));
}

void SettingsTcpFlow::anAddressGoesOutAsOneChange()
{
    m_page->showItem(ItemId::IpAddress1stOctet);
    type(QStringLiteral("192.168.1.77"));
    press(Qt::Key_Return);
    QCOMPARE(m_session->pending().count(), 1);
    QVERIFY(m_session->apply());
    QTRY_VERIFY(m_session->pending().isEmpty());
    QCOMPARE(holds(ItemId::IpAddress4thOctet), 77);
    QCOMPARE(shown(ItemId::IpAddress1stOctet, SettingsModel::InSensor), QStringLiteral("192.168.1.77"));
}

void SettingsTcpFlow::aBankSwitchShowsTheOtherBanksValues()
{
    connect(m_page, &SettingsPage::commandRequested, m_session.get(),
            [this](ItemId item, Value value) { m_session->run(item, value); });
    m_session->edit({{ItemId::OutputDelayTimerSetting, 20}});
    QVERIFY(m_session->apply());
    QTRY_COMPARE(shown(ItemId::OutputDelayTimerSetting, SettingsModel::InSensor), QStringLiteral("20"));
    auto* two = m_page->findChild<QPushButton*>(QStringLiteral("bank2"));
    QTRY_VERIFY(two->isEnabled());
    QTest::mouseClick(two, Qt::LeftButton);
    QTRY_VERIFY(two->isChecked());
    QTRY_COMPARE(shown(ItemId::OutputDelayTimerSetting, SettingsModel::InSensor), QStringLiteral("1"));
    QCOMPARE(holds(ItemId::BankSwitching), 2);
}

void SettingsTcpFlow::whatTheKeypadChangesIsSeenWhileAnEditorIsOpen()
{
    m_page->showItem(ItemId::Offset);
    type(QStringLiteral("2.5"));
    m_session->edit({{ItemId::Span, 20000}});
    m_device->post([](SensorStation& station) {
        station.sensor().changeByKeypad(ItemId::Span, 15000);
        station.sensor().changeByKeypad(ItemId::Offset, 10000);
    });
    QTRY_COMPARE(shown(ItemId::Offset, SettingsModel::InSensor), QStringLiteral("+1.000"));
    QTRY_VERIFY(model().states(*model().tree()->find(ItemId::Span)).testFlag(SettingsModel::Conflict));
    press(Qt::Key_Return); // the editor is still there, with what was typed
    QCOMPARE(shown(ItemId::Offset, SettingsModel::NewValue), QStringLiteral("+2.500"));
    m_page->showItem(ItemId::Span);
    auto* take = m_page->findChild<QPushButton*>(QStringLiteral("takeSensors"));
    QTRY_VERIFY(take->isVisible());
    QTest::mouseClick(take, Qt::LeftButton);
    QCOMPARE(shown(ItemId::Span, SettingsModel::NewValue), QStringLiteral("1.5000"));
}

void SettingsTcpFlow::aCutLeavesTheLastKnownValuesMarked()
{
    m_session->edit({{ItemId::Span, 20000}});
    m_device.reset();
    QTRY_VERIFY(m_session->isStale());
    QCOMPARE(model().headerData(SettingsModel::InSensor, Qt::Horizontal, Qt::DisplayRole).toString(),
             QStringLiteral("Last known"));
    QVERIFY(m_page->findChild<QLabel*>(QStringLiteral("staleNote"))->isVisible());
    QCOMPARE(shown(ItemId::Span, SettingsModel::InSensor), QStringLiteral("1.0000"));
    QCOMPARE(shown(ItemId::Span, SettingsModel::NewValue), QStringLiteral("2.0000"));
}

QTEST_MAIN(SettingsTcpFlow)
#include "flow_settings_tcp.moc"
