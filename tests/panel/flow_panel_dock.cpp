#include "panel_dock.h"
#include "window_fixture.h"

#include <QDir>
#include <QMenu>
#include <QSignalSpy>

using namespace lds;
using namespace lds::flows;
using namespace Qt::StringLiterals;
using app::PanelDock;
using emulator::DemoSensor;

/// The front panel's dock in the real window.
class FlowPanelDock : public QObject {
    Q_OBJECT

private:
    static void waitForDemo(WindowFixture& fixture)
    {
        if (fixture.device->port() == 0) {
            QSignalSpy ready(fixture.device.get(), &DemoSensor::ready);
            QTRY_COMPARE(ready.size(), 1);
        }
    }
    static QAction* viewAction(WindowFixture& fixture)
    {
        const auto menus = fixture.window->findChildren<QMenu*>();
        for (const QMenu* menu : menus) {
            const auto actions = menu->actions();
            for (QAction* action : actions) {
                if (menu->title() == u"&View"_s && action->text() == u"Sensor front panel"_s)
                    return action;
            }
        }
        return nullptr;
    }
    static PanelDock* addDock(WindowFixture& fixture)
    {
        auto* dock = new PanelDock(*fixture.device, fixture.window.get());
        fixture.window->addDock(dock);
        return dock;
    }

private Q_SLOTS:
    void the_dock_is_hidden_until_the_view_menu_shows_it()
    {
        WindowFixture fixture;
        waitForDemo(fixture);
        fixture.window->resize(1024, 700);
        const PanelDock* dock = addDock(fixture);
        QVERIFY(dock->isHidden());
        QVERIFY(viewAction(fixture));
        viewAction(fixture)->trigger();
        QTRY_VERIFY(dock->isVisible());
        QTRY_COMPARE(dock->widget()->visibleRegion().boundingRect().size(), dock->widget()->size());
        QCOMPARE(fixture.window->size(), QSize(1024, 700)); // there is room for it
        if (qEnvironmentVariableIsSet("LDS_PICTURES")) {
            ports::ConnectionUrl url;
            url.host = u"127.0.0.1"_s;
            url.port = fixture.device->port();
            url.sensor = catalog::SensorModel::HlG203;
            fixture.workspace.add(url, u"Virtual sensor"_s)->open();
            QTRY_VERIFY(fixture.session() && fixture.session()->latest().has_value());
            const QString file = QDir(qEnvironmentVariable("LDS_PICTURES")).filePath(u"window.png"_s);
            QVERIFY(fixture.window->grab().save(file));
        }
    }

    void a_dock_that_was_left_open_is_open_again()
    {
        WindowFixture fixture;
        waitForDemo(fixture);
        addDock(fixture)->show();
        QVERIFY(fixture.window->close());
        fixture.window = std::make_unique<ui::MainWindow>(fixture.workspace, fixture.log, fixture.scheduler,
                                                          fixture.settings);
        fixture.window->show();
        QVERIFY(addDock(fixture)->isVisible());
    }
};

QTEST_MAIN(FlowPanelDock)
#include "flow_panel_dock.moc"
