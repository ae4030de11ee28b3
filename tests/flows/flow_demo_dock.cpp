// The dock of the demonstration, by mouse and keys, on a running virtual sensor.
#include "demo_dock.h"
#include "window_fixture.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QScrollArea>

using namespace lds;
using namespace lds::flows;
using namespace Qt::StringLiterals;
using emulator::DemoSensor;
using emulator::FaultDesk;
using emulator::NamedFault;
using emulator::StationState;

class DemoDockFlow : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void isDisabledUntilTheSensorRuns();
    void showsWhatTheSensorHas();
    void aSceneIsChosenWithTheKeyboard();
    void aWorkpieceIsHeldStillAndMovesAgain();
    void aRefusedSceneSaysWhyAndTheOldOneStays();
    void aSceneOfAFileGetsARow();
    void faultsAreSwitchedWithTheKeyboard();
    void aFaultOfTheSceneIsShownBesideThePersons();
    void savingCannotBeSwitchedOff();
    void theTriggerInputIsSwitched();
    void thePowerIsCycled();
    void everyControlHasANameAndIsReachedByTab();
    void leavesTheWindowItsSize();

private:
    StationState state()
    {
        return m_sensor->ask([](SensorStation& station) { return station.state(); });
    }
    template <typename Widget>
    Widget& widget(const char* name)
    {
        auto* found = m_dock->findChild<Widget*>(QLatin1StringView(name));
        if (!found)
            qFatal("no %s", name);
        return *found;
    }
    QComboBox& scenes() { return widget<QComboBox>("demoScene"); }
    QComboBox& workpieces() { return widget<QComboBox>("demoWorkpiece"); }
    QCheckBox& fault(NamedFault fault)
    {
        return widget<QCheckBox>(qPrintable(u"demoFault_"_s + keyOf(fault)));
    }
    void chooseScene(const QString& key);

    std::unique_ptr<DemoSensor> m_sensor;
    std::unique_ptr<app::DemoDock> m_dock;
};

void DemoDockFlow::init()
{
    m_sensor = std::make_unique<DemoSensor>(catalog::SensorModel::HlG203);
    m_dock = std::make_unique<app::DemoDock>(*m_sensor);
    m_sensor->start();
    m_dock->show();
    QTRY_VERIFY(m_dock->widget()->isEnabled());
    m_dock->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_dock.get()));
}

void DemoDockFlow::cleanup()
{
    m_dock.reset();
    m_sensor.reset();
}

void DemoDockFlow::chooseScene(const QString& key)
{
    const int index = scenes().findData(key);
    QVERIFY2(index > 0, qPrintable(key));
    scenes().setFocus();
    QTest::keyClick(&scenes(), Qt::Key_Home);
    for (int row = 0; row < index; ++row)
        QTest::keyClick(&scenes(), Qt::Key_Down);
    QTRY_COMPARE(state().scene, key);
}

void DemoDockFlow::isDisabledUntilTheSensorRuns()
{
    DemoSensor sensor(catalog::SensorModel::HlG203);
    const app::DemoDock dock(sensor);
    QVERIFY(!dock.widget()->isEnabled());
}

void DemoDockFlow::showsWhatTheSensorHas()
{
    QCOMPARE(scenes().count(), 6);
    QCOMPARE(scenes().currentText(), u"Moves gently"_s);
    QCOMPARE(workpieces().currentText(), u"Moving"_s);
    for (const NamedFault each : emulator::allFaults())
        QVERIFY(!fault(each).isChecked());
    m_sensor->post([](SensorStation& station) {
        station.faults().switchOn(NamedFault::NoLight, FaultDesk::By::Person);
        station.player().setTrigger(true);
    });
    QTRY_VERIFY(fault(NamedFault::NoLight).isChecked());
    QTRY_VERIFY(widget<QPushButton>("demoTrigger").isChecked());
}

void DemoDockFlow::aSceneIsChosenWithTheKeyboard()
{
    chooseScene(u"rotating-shaft"_s);
    QTRY_COMPARE(workpieces().count(), 1 + int(state().workpieces.size()));
    scenes().setFocus();
    QTest::keyClick(&scenes(), Qt::Key_Home);
    QTRY_COMPARE(state().scene, QString());
    QTRY_COMPARE(workpieces().itemText(1), u"Held still at the centre"_s);
}

void DemoDockFlow::aWorkpieceIsHeldStillAndMovesAgain()
{
    chooseScene(u"rubber-and-steel"_s);
    QTRY_VERIFY(workpieces().findText(u"black rubber"_s) > 0);
    workpieces().setFocus();
    QTest::keyClick(&workpieces(), Qt::Key_Down);
    QTRY_COMPARE(state().held, u"steel"_s);
    QTest::keyClick(&workpieces(), Qt::Key_Down);
    QTRY_COMPARE(state().held, u"black rubber"_s);
    QTRY_COMPARE(workpieces().currentText(), u"black rubber"_s);
    QTest::keyClick(&workpieces(), Qt::Key_Home);
    QTRY_COMPARE(state().held, QString());
    scenes().setFocus();
    QTest::keyClick(&scenes(), Qt::Key_Home);
    QTRY_COMPARE(workpieces().itemText(1), u"Held still at the centre"_s);
    workpieces().setFocus();
    QTest::keyClick(&workpieces(), Qt::Key_Down);
    QTRY_COMPARE(state().heldAt, 0);
}

void DemoDockFlow::aRefusedSceneSaysWhyAndTheOldOneStays()
{
    auto& error = widget<QLabel>("demoError");
    QVERIFY(error.isHidden());
    chooseScene(u"conveyor-step"_s);
    m_sensor->loadScene(u"/nowhere/scene.json"_s);
    QTRY_VERIFY(!error.isHidden());
    QVERIFY2(error.text().contains(u"/nowhere/scene.json"_s), qPrintable(error.text()));
    QCOMPARE(state().scene, u"conveyor-step"_s);
    QCOMPARE(scenes().currentData().toString(), u"conveyor-step"_s);
    chooseScene(u"missing-parts"_s);
    QVERIFY(error.isHidden()); // it is about another one
}

void DemoDockFlow::aSceneOfAFileGetsARow()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"mine.json"_s);
    QVERIFY(
        QFile::copy(qEnvironmentVariable("LDS_SOURCE") + u"/resources/scenes/conveyor-step.json"_s, path));
    for (int time = 0; time < 2; ++time) {
        m_sensor->loadScene(path);
        QTRY_COMPARE(scenes().currentText(), u"mine.json"_s);
        QCOMPARE(scenes().count(), 7);
        chooseScene(u"conveyor-step"_s);
    }
}

void DemoDockFlow::faultsAreSwitchedWithTheKeyboard()
{
    for (const NamedFault each : emulator::allFaults()) {
        if (each == NamedFault::Saving)
            continue;
        fault(each).setFocus();
        QTest::keyClick(&fault(each), Qt::Key_Space);
        const auto isOn = [each](SensorStation& station) { return station.faults().isOn(each); };
        QTRY_VERIFY(m_sensor->ask(isOn));
        QTest::keyClick(&fault(each), Qt::Key_Space);
        QTRY_VERIFY(!m_sensor->ask(isOn));
    }
}

void DemoDockFlow::aFaultOfTheSceneIsShownBesideThePersons()
{
    auto& slow = fault(NamedFault::SlowAnswers);
    m_sensor->post([](SensorStation& station) {
        station.faults().switchOn(NamedFault::SlowAnswers, FaultDesk::By::Scene, 250);
    });
    QTRY_COMPARE(slow.text(), u"Slow to answer (250 ms) · scene"_s);
    QVERIFY(!slow.isChecked()); // the box is the person's
    m_sensor->post([](SensorStation& station) { station.faults().switchAllOff(FaultDesk::By::Scene); });
    QTRY_COMPARE(slow.text(), u"Slow to answer"_s);
}

void DemoDockFlow::savingCannotBeSwitchedOff()
{
    auto& saving = fault(NamedFault::Saving);
    saving.setFocus();
    QTest::keyClick(&saving, Qt::Key_Space);
    QTRY_VERIFY(saving.isChecked() && !saving.isEnabled());
    QTest::mouseClick(&widget<QPushButton>("demoPowerCycle"), Qt::LeftButton); // but with the power
    QTRY_VERIFY(!saving.isChecked() && saving.isEnabled());
}

void DemoDockFlow::theTriggerInputIsSwitched()
{
    auto& trigger = widget<QPushButton>("demoTrigger");
    QCOMPARE(trigger.text(), u"&Trigger input: OFF"_s);
    trigger.setFocus();
    QTest::keyClick(&trigger, Qt::Key_Space);
    QTRY_VERIFY(state().triggerByPerson);
    QTRY_COMPARE(trigger.text(), u"&Trigger input: ON"_s);
    QTest::mouseClick(&trigger, Qt::LeftButton);
    QTRY_VERIFY(!state().triggerByPerson);
}

void DemoDockFlow::thePowerIsCycled()
{
    const auto offset = [](SensorStation& station) {
        return station.sensor().memory().value(ItemId::Offset);
    };
    m_sensor->post([](SensorStation& station) { station.sensor().write({{ItemId::Offset, 5}}); });
    QCOMPARE(m_sensor->ask(offset), 5);
    QTest::mouseClick(&widget<QPushButton>("demoPowerCycle"), Qt::LeftButton);
    QTRY_COMPARE(m_sensor->ask(offset), 0);
}

void DemoDockFlow::everyControlHasANameAndIsReachedByTab()
{
    QList<QWidget*> controls;
    const auto widgets = m_dock->widget()->findChildren<QWidget*>();
    for (QWidget* each : widgets) {
        if (qobject_cast<QAbstractButton*>(each) || qobject_cast<QComboBox*>(each))
            controls += each;
    }
    QCOMPARE(controls.size(), 5 + emulator::allFaults().size());
    for (const QWidget* each : std::as_const(controls)) {
        const auto* button = qobject_cast<const QAbstractButton*>(each);
        QVERIFY2(!(button ? button->text() : each->accessibleName()).isEmpty(),
                 qPrintable(each->objectName()));
    }
    scenes().setFocus();
    QSet<QWidget*> reached;
    for (qsizetype i = 0; i < 3 * controls.size(); ++i) {
        reached.insert(QApplication::focusWidget());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    for (QWidget* each : std::as_const(controls))
        QVERIFY2(reached.contains(each), qPrintable(each->objectName()));
}

void DemoDockFlow::leavesTheWindowItsSize()
{
    ui::Theme::instance().apply(*qApp, ui::ThemeMode::Light);
    WindowFixture fixture;
    auto* dock = new app::DemoDock(*fixture.device, fixture.window.get());
    fixture.window->addDock(dock);
    QVERIFY(!dock->isVisible());
    const QSize size(1024, 700);
    fixture.window->resize(size);
    dock->show();
    QTRY_VERIFY(dock->widget()->isEnabled());
    QCOMPARE(fixture.window->size(), size);
    fixture.device->post([](SensorStation& station) { // the longest texts there are
        for (const NamedFault each : emulator::allFaults())
            station.faults().switchOn(each, FaultDesk::By::Scene);
    });
    const auto& saving = *dock->findChild<QCheckBox*>(u"demoFault_saving"_s);
    QTRY_VERIFY(saving.text().contains(u"scene"_s));
    const auto* scroll = qobject_cast<QScrollArea*>(dock->widget());
    QVERIFY(scroll && scroll->widget()->width() <= scroll->viewport()->width()); // nothing is cut off
    QVERIFY2(dock->width() <= size.width() * 3 / 10, qPrintable(QString::number(dock->width())));
    QCOMPARE(fixture.window->size(), size);
    if (const QString folder = qEnvironmentVariable("LDS_PICTURES"); !folder.isEmpty())
        fixture.window->grab().save(folder + u"/demo-dock.png"_s);
}

QTEST_MAIN(DemoDockFlow)
#include "flow_demo_dock.moc"
