// RS-485 as a person meets it: the connection dialog, the scan, the guided change. Mouse and keys on one
// side, virtual sensors behind a pseudo-terminal on the other.

#include "main_window.h"
#include "modbus_link_factory.h"
#include "modbus_scan_factory.h"
#include "qt_scheduler.h"
#include "qt_serial_ports.h"
#include "serial_choices.h"
#include "theme.h"
#include "virtual_line.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QSpinBox>
#include <QTableView>
#include <QTest>

using namespace lds;
using namespace lds::flows;
using namespace Qt::StringLiterals;
using catalog::ItemId;
using emulator::SensorStation;
using ports::SerialParity;

namespace {

/// Machines that test are busy: a sensor is given more time to answer than a person would wait for.
modbus::ScanTiming patient()
{
    modbus::ScanTiming timing;
    timing.answerMs = 250;
    return timing;
}

class SerialWindow {
public:
    explicit SerialWindow(const QString& settingsFile)
        : settings(settingsFile, QSettings::IniFormat)
    {
        window.setSerial(serialPorts, scans, links);
        window.resize(1024, 700);
        window.show();
        activate();
    }
    ~SerialWindow()
    {
        for (QDialog* dialog : window.findChildren<QDialog*>())
            delete dialog;
        for (auto* session : QList(workspace.sessions()))
            workspace.remove(session);
    }
    void activate()
    {
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window))
            qFatal("the window does not become active");
    }

    ui::MessageLog log;
    ports::QtScheduler scheduler;
    modbus::ModbusLinkFactory links{log};
    modbus::QtSerialPorts serialPorts;
    modbus::ModbusScanFactory scans{links.buses(), links.thread(), patient()};
    sensor::Workspace workspace{links, scheduler};
    QSettings settings;
    ui::MainWindow window{workspace, log, scheduler, settings};
};

} // namespace

class SerialFlow : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<VirtualLine> m_line;
    std::unique_ptr<SerialWindow> m_w;

    QDialog* dialog(const char* name) const
    {
        for (QDialog* each : m_w->window.findChildren<QDialog*>(QLatin1StringView(name))) {
            if (each->isVisible())
                return each;
        }
        return nullptr;
    }
    template <typename Widget>
    static Widget* find(QWidget* in, const char* name)
    {
        auto* found = in->findChild<Widget*>(QLatin1StringView(name));
        if (!found)
            qFatal("there is no %s", name);
        return found;
    }
    static void click(QWidget* in, const char* name)
    {
        auto* button = find<QAbstractButton>(in, name);
        QTest::mouseClick(button, Qt::LeftButton, {}, QPoint(8, button->height() / 2));
    }
    static void type(QLineEdit* edit, const QString& text)
    {
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
    }
    QAction* action(const char* name) const
    {
        return m_w->window.findChild<QAction*>(QLatin1StringView(name));
    }

    QDialog* openConnect(const QString& port, const QString& units)
    {
        QTest::keyClick(&m_w->window, Qt::Key_K, Qt::ControlModifier);
        QDialog* connect = dialog("connectDialog");
        if (!connect)
            qFatal("no connection dialog");
        click(connect, "kindSerial");
        type(find<QComboBox>(connect, "serialPort")->lineEdit(), port);
        type(find<QLineEdit>(connect, "units"), units);
        return connect;
    }
    void connectUnits(const QString& units, int count)
    {
        QDialog* connect = openConnect(m_line->port(), units);
        QTest::keyClick(connect, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(m_w->workspace.sessions().size(), count, 20'000);
        for (const auto* session : m_w->workspace.sessions())
            QTRY_VERIFY_WITH_TIMEOUT(session->isReady(), 20'000);
        QTRY_VERIFY(!dialog("connectDialog"));
        m_w->activate();
    }
    void makeLine(const QList<quint8>& units)
    {
        m_line = std::make_unique<VirtualLine>(units);
        m_w = std::make_unique<SerialWindow>(m_folder.filePath(u"settings.ini"_s));
    }
    catalog::Value saved(std::size_t index, ItemId item)
    {
        return m_line->ask(
            index, [item](SensorStation& station) { return station.sensor().savedMemory().value(item); });
    }

    int writes(std::size_t index)
    {
        return m_line->ask(index, [](SensorStation& station) { return station.sensor().totalWriteCount(); });
    }

private Q_SLOTS:
    void initTestCase()
    {
        ports::registerMetaTypes();
        ui::Theme::instance().apply(*qApp, ui::ThemeMode::Light);
    }
    void cleanup()
    {
        m_w.reset();
        m_line.reset();
    }

    void connectsTwoSensorsOfOneLineAndShowsTheirValues()
    {
        makeLine({1, 3});
        connectUnits(u"1, 3"_s, 2);
        QCOMPARE(m_w->workspace.current()->url().unit, 1);
        for (const auto* session : m_w->workspace.sessions())
            QTRY_VERIFY_WITH_TIMEOUT(session->latest().has_value(), 20'000);
    }

    void aPortThatIsNotThereIsSaidAndNothingTypedIsLost()
    {
        makeLine({1});
        QDialog* connect = openConnect(u"/dev/no-such-port"_s, u"7"_s);
        QTest::keyClick(connect, Qt::Key_Return);
        auto* state = find<QLabel>(connect, "connectState");
        QTRY_VERIFY_WITH_TIMEOUT(state->property("error").toBool() && state->isVisible(), 20'000);
        QVERIFY2(state->text().contains(u"/dev/no-such-port"_s), qPrintable(state->text()));
        QCOMPARE(find<QComboBox>(connect, "serialPort")->currentText(), u"/dev/no-such-port"_s);
        QCOMPARE(find<QLineEdit>(connect, "units")->text(), u"7"_s);
        // The right port, and it stands.
        type(find<QComboBox>(connect, "serialPort")->lineEdit(), m_line->port());
        type(find<QLineEdit>(connect, "units"), u"1"_s);
        QTest::keyClick(connect, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(m_w->workspace.current() && m_w->workspace.current()->isReady(), 20'000);
    }

    void anAdapterPulledOutAndBackIsConnectedByItself()
    {
        makeLine({1, 3});
        connectUnits(u"1, 3"_s, 2);
        auto* first = m_w->workspace.sessions().first();
        auto* second = m_w->workspace.sessions().last();
        first->edit({{ItemId::HighSetValue, 17'500}});
        const int written = writes(0);
        m_line->unplug();
        for (const auto* session : {first, second}) {
            QTRY_COMPARE_WITH_TIMEOUT(session->connection(), sensor::Connection::Reconnecting, 20'000);
            QTRY_VERIFY(session->linkReport().failure != ports::OpenFailure::None);
        }
        QVERIFY(first->pending().find(ItemId::HighSetValue)); // nothing entered is lost
        m_line->plugIn();
        for (const auto* session : {first, second}) {
            QTRY_VERIFY_WITH_TIMEOUT(session->isReady(), 60'000);
            const qint64 before = session->trend().lastNs();
            QTRY_VERIFY_WITH_TIMEOUT(session->trend().lastNs() > before, 20'000);
        }
        // Reconnecting reads and never writes.
        QVERIFY(first->pending().find(ItemId::HighSetValue));
        QCOMPARE(writes(0), written);
    }

    void aScanFindsSensorsTellsTwoUnitsAndAddsThem()
    {
        makeLine({2, 4, 5, 5});
        action("scan")->trigger();
        QDialog* scan = dialog("scanDialog");
        QVERIFY(scan);
        type(find<QComboBox>(scan, "scanPort")->lineEdit(), m_line->port());
        find<QSpinBox>(scan, "firstUnit")->setValue(1);
        find<QSpinBox>(scan, "lastUnit")->setValue(6);
        click(scan, "scanButton");
        auto* findings = find<QTableView>(scan, "scanFindings")->model();
        QTRY_VERIFY_WITH_TIMEOUT(!find<QLabel>(scan, "scanState")->text().startsWith(u"Asking"_s) &&
                                     find<QWidget>(scan, "scanPort")->isEnabled(),
                                 60'000);
        QStringList found;
        for (int row = 0; row < findings->rowCount(); ++row)
            found +=
                findings->index(row, 0).data().toString() + u' ' + findings->index(row, 1).data().toString();
        QCOMPARE(found, (QStringList{u"2 HL-G2 sensor"_s, u"4 HL-G2 sensor"_s, u"5 Two units answer"_s}));
        QCOMPARE(find<QPushButton>(scan, "addButton")->text(), u"&Add 2 sensors"_s);
        QTest::keyClick(scan, Qt::Key_Return);
        QTRY_COMPARE(m_w->workspace.sessions().size(), 2);
        for (const auto* session : m_w->workspace.sessions())
            QTRY_VERIFY_WITH_TIMEOUT(session->isReady(), 20'000);
    }

    void aScanTakesTurnsWithASensorThatIsConnected()
    {
        makeLine({2, 4});
        connectUnits(u"2"_s, 1);
        auto* connected = m_w->workspace.current();
        QTRY_VERIFY_WITH_TIMEOUT(connected->latest().has_value(), 20'000);
        action("scan")->trigger();
        QDialog* scan = dialog("scanDialog");
        QVERIFY(scan);
        type(find<QComboBox>(scan, "scanPort")->lineEdit(), m_line->port());
        find<QSpinBox>(scan, "lastUnit")->setValue(5);
        click(scan, "scanButton");
        QTRY_VERIFY_WITH_TIMEOUT(find<QLabel>(scan, "scanState")->text().startsWith(u"Done"_s), 60'000);
        auto* findings = find<QTableView>(scan, "scanFindings")->model();
        QCOMPARE(findings->rowCount(), 2);
        QCOMPARE(findings->index(0, 3).data().toString(), u"in the list"_s);
        QCOMPARE(findings->index(1, 0).data().toString(), u"4"_s);
        QVERIFY(connected->isReady()); // never cut
        const qint64 before = connected->trend().lastNs();
        QTRY_VERIFY_WITH_TIMEOUT(connected->trend().lastNs() > before, 20'000);
    }

    void aScanCanBeStopped()
    {
        makeLine({2});
        action("scan")->trigger();
        QDialog* scan = dialog("scanDialog");
        type(find<QComboBox>(scan, "scanPort")->lineEdit(), m_line->port());
        click(scan, "scanButton");
        QTRY_VERIFY_WITH_TIMEOUT(find<QTableView>(scan, "scanFindings")->model()->rowCount() == 1, 20'000);
        click(scan, "scanButton");
        QTRY_VERIFY(find<QLabel>(scan, "scanState")->text().startsWith(u"Stopped"_s));
        QVERIFY(find<QWidget>(scan, "scanPort")->isEnabled());
    }

    void theGuidedChangeMovesASensorToAnotherAddressAndSpeed()
    {
        makeLine({1, 3});
        connectUnits(u"1"_s, 1);
        auto* session = m_w->workspace.current();
        session->edit({{ItemId::HighSetValue, 12'340}});
        QTRY_VERIFY(action("changeCommunication")->isEnabled());
        action("changeCommunication")->trigger();
        QDialog* change = dialog("changeCommunicationDialog");
        QVERIFY(change);

        // Address 3 answers already: nothing is written.
        find<QSpinBox>(change, "newUnit")->setFocus();
        QTest::keyClicks(find<QSpinBox>(change, "newUnit"), u"3"_s);
        QTest::keyClick(change, Qt::Key_Return);
        auto* sentence = find<QLabel>(change, "changeSentence");
        QTRY_VERIFY_WITH_TIMEOUT(sentence->text().contains(u"answers to address 3"_s), 20'000);
        QCOMPARE(saved(0, ItemId::DeviceAddress), 1);

        auto* unit = find<QSpinBox>(change, "newUnit");
        unit->setFocus();
        unit->selectAll();
        QTest::keyClicks(unit, u"9"_s);
        find<QComboBox>(change, "newSpeed")->setCurrentText(u"115200 bps"_s);
        find<QComboBox>(change, "newParity")->setCurrentText(u"ODD + 1bit"_s);
        QTest::keyClick(change, Qt::Key_Return);
        QTRY_VERIFY2_WITH_TIMEOUT(sentence->text().startsWith(u"Done."_s), qPrintable(sentence->text()),
                                  30'000);
        QTest::keyClick(change, Qt::Key_Return);
        QTRY_VERIFY(!dialog("changeCommunicationDialog"));

        QCOMPARE(session->url().unit, 9);
        QCOMPARE(session->url().serial, (ports::SerialSettings{115'200, SerialParity::Odd}));
        QVERIFY(session->isReady());
        QCOMPARE(session->pending().count(), 1);
        QCOMPARE(saved(0, ItemId::DeviceAddress), 9);
        QCOMPARE(saved(0, ItemId::CommunicationSpeed), *ports::speedCode(115'200));
        QCOMPARE(saved(0, ItemId::ParityStopBit), ports::parityCode(SerialParity::Odd));
    }
};

QTEST_MAIN(SerialFlow)
#include "flow_serial.moc"
