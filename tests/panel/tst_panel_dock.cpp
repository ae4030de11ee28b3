#include "display_view.h"
#include "front_panel.h"
#include "panel_dock.h"

#include <QDir>
#include <QMainWindow>
#include <QPointer>
#include <QSignalSpy>
#include <QTest>

using namespace lds;
using namespace lds::catalog;
using namespace Qt::StringLiterals;
using app::PanelDock;
using emulator::DemoSensor;
using emulator::ScreenKind;
using emulator::SensorStation;

/// The demo's front panel: widget in one thread, sensor and panel in another.
class TestPanelDock : public QObject {
    Q_OBJECT

private:
    static constexpr int longMs = 10'000; ///< For what takes two real seconds.

    bool isReady() const
    {
        return m_demo->ask([](SensorStation& station) { return station.sensor().isReady(); });
    }
    ScreenKind screen() const { return m_dock->panel().content().screen; }

    std::unique_ptr<DemoSensor> m_demo;
    std::unique_ptr<QMainWindow> m_window;
    PanelDock* m_dock = nullptr;

private Q_SLOTS:
    void init()
    {
        m_demo = std::make_unique<DemoSensor>(SensorModel::HlG205);
        QSignalSpy ready(m_demo.get(), &DemoSensor::ready);
        m_demo->start();
        QTRY_COMPARE(ready.size(), 1);
        m_window = std::make_unique<QMainWindow>();
        m_dock = new PanelDock(*m_demo, m_window.get());
        m_window->addDockWidget(Qt::RightDockWidgetArea, m_dock);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QTRY_COMPARE(screen(), ScreenKind::Measurement);
        m_dock->panel().setFocus();
    }
    void cleanup()
    {
        m_window.reset();
        m_demo.reset();
    }

    void it_shows_what_the_sensor_measures()
    {
        m_demo->runAndWait([](SensorStation& station) { station.sensor().placeWorkpiece(12'340); });
        QTRY_COMPARE(m_dock->panel().content().body, u"+1.234"_s);
    }

    void it_is_drawn_narrow_and_wide()
    {
        for (const int width : {m_dock->minimumSizeHint().width(), 420}) {
            m_dock->setFloating(true);
            m_dock->resize(width, 420);
            QTRY_COMPARE(m_dock->width(), width);
            const auto* display = m_dock->panel().findChild<emulator::DisplayView*>();
            QVERIFY(display->height() >= display->width() / 2 - 1); // as wide as it may be
            if (qEnvironmentVariableIsSet("LDS_PICTURES")) {
                const QString file =
                    QDir(qEnvironmentVariable("LDS_PICTURES")).filePath(u"dock-%1.png"_s.arg(width));
                QVERIFY(m_dock->grab().save(file));
            }
        }
    }

    void its_keys_reach_the_sensor()
    {
        m_demo->runAndWait([](SensorStation& station) { station.sensor().placeWorkpiece(12'340); });
        QTest::keyPress(&m_dock->panel(), Qt::Key_Up);
        QTest::keyPress(&m_dock->panel(), Qt::Key_Down);
        QTest::keyRelease(&m_dock->panel(), Qt::Key_Up);
        QTest::keyRelease(&m_dock->panel(), Qt::Key_Down);
        QTRY_VERIFY(m_dock->panel().content().icons.zero);
        QTRY_COMPARE(m_dock->panel().content().body, u"+0.000"_s);
    }

    void the_setting_mode_makes_the_sensor_not_ready_until_the_dock_is_closed()
    {
        QVERIFY(isReady());
        QTest::keyPress(&m_dock->panel(), Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(screen(), ScreenKind::Menu, longMs);
        QTest::keyRelease(&m_dock->panel(), Qt::Key_Return);
        QVERIFY(!isReady());
        m_dock->close();
        QTRY_VERIFY(isReady());
        QTRY_COMPARE(screen(), ScreenKind::Measurement);
    }

    void the_power_button_switches_the_sensor_off_and_on()
    {
        Q_EMIT m_dock->panel().powerCycleRequested();
        QTRY_COMPARE(screen(), ScreenKind::StartUp);
        QTRY_COMPARE_WITH_TIMEOUT(screen(), ScreenKind::Measurement, longMs);
    }

    void a_dock_may_go_while_its_panel_is_being_made()
    {
        for (int i = 0; i < 20; ++i)
            delete new PanelDock(*m_demo);
        QVERIFY(isReady());
        QCoreApplication::processEvents();
    }
};

QTEST_MAIN(TestPanelDock)
#include "tst_panel_dock.moc"
