#include "change_communication_dialog.h"
#include "connect_dialog.h"
#include "connection_form.h"
#include "fake_link.h"
#include "manual_scheduler.h"
#include "port_box.h"
#include "scan_dialog.h"
#include "scripted_scans.h"
#include "serial_choices.h"
#include "theme.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

using namespace lds;
using namespace lds::ui;
using namespace Qt::StringLiterals;
using catalog::ItemId;
using ports::ScanEnd;
using ports::ScanFinding;
using ports::SerialParity;
using procedures::CommunicationChange;
using support::settle;
using Kind = ScanFinding::Kind;
using State = CommunicationChange::State;

namespace {

ports::ConnectionUrl urlOf(int unit, const ports::SerialSettings& serial = {})
{
    ports::ConnectionUrl url;
    url.protocol = ports::Protocol::ModbusRtu;
    url.host = u"/dev/ttyUSB0"_s;
    url.serial = serial;
    url.unit = quint8(unit);
    return url;
}

} // namespace

/// The dialogs of RS-485 on sensors in memory and a scan that the test plays.
class SerialDialogsTest : public QObject {
    Q_OBJECT

    ports::ManualScheduler m_scheduler;
    std::unique_ptr<support::FakeLinkFactory> m_links;
    std::unique_ptr<sensor::Workspace> m_workspace;
    ScriptedPorts m_ports;
    ScriptedScans m_scans;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<QSettings> m_settings;

    template <typename Widget>
    static Widget* find(QWidget& in, const char* name)
    {
        auto* found = in.findChild<Widget*>(QLatin1StringView(name));
        if (!found)
            qFatal("there is no %s", name);
        return found;
    }
    static void click(QWidget& in, const char* name)
    {
        auto* button = find<QAbstractButton>(in, name);
        QTest::mouseClick(
            button, Qt::LeftButton, {},
            QPoint(qobject_cast<QRadioButton*>(button) ? 8 : button->width() / 2, button->height() / 2));
        settle();
    }
    static QString text(QWidget& in, const char* name) { return find<QLabel>(in, name)->text(); }
    static void type(QWidget& in, const char* name, const QString& text)
    {
        auto* edit = find<QLineEdit>(in, name);
        edit->selectAll();
        QTest::keyClicks(edit, text);
    }

    /// For whoever wants to look at them: LDS_PICTURES names a folder.
    static void picture(QWidget& widget, const QString& name)
    {
        const QString folder = qEnvironmentVariable("LDS_PICTURES");
        if (folder.isEmpty())
            return;
        QVERIFY(QDir().mkpath(folder));
        for (const ThemeMode mode : {ThemeMode::Dark, ThemeMode::Light}) {
            Theme::instance().setMode(mode);
            QCoreApplication::processEvents();
            const QString theme = mode == ThemeMode::Dark ? u"dark"_s : u"light"_s;
            QVERIFY(widget.grab().save(u"%1/%2-%3.png"_s.arg(folder, name, theme)));
        }
    }

    sensor::SensorSession* connected(int unit)
    {
        m_links->place(urlOf(unit));
        auto* session = m_workspace->add(urlOf(unit));
        session->open();
        settle();
        return session;
    }
    std::unique_ptr<ScanDialog> openScan()
    {
        auto dialog = std::make_unique<ScanDialog>(*m_workspace, &m_ports, m_scans, m_scheduler);
        dialog->setAttribute(Qt::WA_DeleteOnClose, false);
        dialog->show();
        return dialog;
    }
    void pass(int ms)
    {
        for (int gone = 0; gone < ms; gone += 100) {
            m_scheduler.advanceMs(100);
            settle();
        }
    }

private Q_SLOTS:
    void initTestCase()
    {
        ports::registerMetaTypes();
        Theme::instance().apply(*qApp, ThemeMode::Light);
    }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_settings = std::make_unique<QSettings>(m_folder->filePath(u"s.ini"_s), QSettings::IniFormat);
        m_links = std::make_unique<support::FakeLinkFactory>(m_scheduler);
        m_workspace = std::make_unique<sensor::Workspace>(*m_links, m_scheduler);
        m_ports.now = {{u"/dev/ttyUSB0"_s, u"USB-RS485 adapter"_s, u"0403:6001:A1"_s},
                       {u"/dev/ttyS0"_s, {}, {}}};
    }
    void cleanup()
    {
        m_workspace.reset();
        settle();
        m_links.reset();
    }

    // --- Ports

    void portsAreListedAnewWhenTheListOpensAndTypedByHandToo()
    {
        PortBox box(&m_ports);
        box.show();
        QCOMPARE(box.port(), u"/dev/ttyUSB0"_s);
        QCOMPARE(box.count(), 2);
        QCOMPARE(box.itemText(0), u"/dev/ttyUSB0 \u2013 USB-RS485 adapter"_s);
        box.lineEdit()->selectAll();
        QTest::keyClicks(box.lineEdit(), u"/tmp/line"_s);
        m_ports.now += {u"/dev/ttyUSB1"_s, u"Another"_s, {}};
        box.showPopup();
        QCOMPARE(box.count(), 3);
        QCOMPARE(box.port(), u"/tmp/line"_s); // what was typed stays
        QTest::keyClick(box.view(), Qt::Key_End);
        QTest::keyClick(box.view(), Qt::Key_Return);
        QCOMPARE(box.port(), u"/dev/ttyUSB1"_s); // the name alone
    }

    void withoutAnyPortTheListSaysSo()
    {
        m_ports.now.clear();
        PortBox box(&m_ports);
        QCOMPARE(box.port(), QString());
        QCOMPARE(box.count(), 1);
        QVERIFY(!(box.model()->flags(box.model()->index(0, 0)) & Qt::ItemIsEnabled));
        QVERIFY(!box.error().isEmpty());
    }

    // --- The connection form

    void switchingTheKindLosesNothing()
    {
        ConnectionForm form(&m_ports);
        form.show();
        type(form, "host", u"10.0.0.7"_s);
        type(form, "port", u"49152"_s);
        click(form, "kindSerial");
        QVERIFY(!find<QLineEdit>(form, "host")->isVisible());
        type(form, "units", u"12"_s);
        find<PortBox>(form, "serialPort")->setPort(u"COM3"_s);
        click(form, "kindEthernet");
        QCOMPARE(find<QLineEdit>(form, "host")->text(), u"10.0.0.7"_s);
        QCOMPARE(form.check()->port, 49152);
        click(form, "kindSerial");
        QCOMPARE(form.check()->host, u"COM3"_s);
        QCOMPARE(form.check()->unit, 12);
    }

    void everyAddressOfAListIsAConnection()
    {
        ConnectionForm form(&m_ports);
        form.show();
        click(form, "kindSerial");
        type(form, "units", u"1-3, 9"_s);
        type(form, "name", u"Press"_s);
        const auto urls = form.checkAll();
        QCOMPARE(urls.size(), 4);
        QCOMPARE(urls.last(), urlOf(9));
        QCOMPARE(form.nameFor(urls.last()), u"Press \u00b7 9"_s);
        QVERIFY2(text(form, "url").contains(u"3 more"_s), qPrintable(text(form, "url")));
    }

    void serialFieldsSayWhatIsWrongBesideThem_data()
    {
        QTest::addColumn<QString>("port");
        QTest::addColumn<QString>("units");
        QTest::addColumn<QByteArray>("wrong");
        QTest::newRow("no port") << QString() << u"1"_s << QByteArray("serialPortError");
        QTest::newRow("no address") << u"COM3"_s << QString() << QByteArray("unitsError");
        QTest::newRow("address 0") << u"COM3"_s << u"0"_s << QByteArray("unitsError");
        QTest::newRow("address 248") << u"COM3"_s << u"248"_s << QByteArray("unitsError");
        QTest::newRow("too many") << u"COM3"_s << u"1-17"_s << QByteArray("unitsError");
        QTest::newRow("bad URL") << u"modbus-rtu:COM3?baud=7"_s << u"1"_s << QByteArray("serialPortError");
        QTest::newRow("all right") << u"COM3"_s << u"1-16"_s << QByteArray();
    }
    void serialFieldsSayWhatIsWrongBesideThem()
    {
        QFETCH(QString, port);
        QFETCH(QString, units);
        QFETCH(QByteArray, wrong);
        ConnectionForm form(&m_ports);
        form.show();
        click(form, "kindSerial");
        find<PortBox>(form, "serialPort")->setPort(port);
        find<QLineEdit>(form, "units")->setText(units);
        QCOMPARE(form.checkAll().isEmpty(), !wrong.isEmpty());
        for (const char* label : {"serialPortError", "unitsError"})
            QCOMPARE(text(form, label).isEmpty(), wrong != label);
        QCOMPARE(find<PortBox>(form, "serialPort")->port(), port);
        QCOMPARE(find<QLineEdit>(form, "units")->text(), units);
    }

    void aPastedUrlFillsTheFieldsOfItsKind()
    {
        ConnectionForm form(&m_ports);
        form.show();
        type(form, "host", u"modbus-rtu:COM5?baud=115200&parity=odd&stop=1&unit=9&view=only"_s);
        const auto url = form.check();
        QVERIFY(url);
        QVERIFY(find<QRadioButton>(form, "kindSerial")->isChecked());
        ports::ConnectionUrl expected = urlOf(9, {115'200, SerialParity::Odd});
        expected.host = u"COM5"_s;
        expected.viewOnly = true;
        QCOMPARE(*url, expected);

        find<PortBox>(form, "serialPort")->setPort(u"modbus-tcp://10.0.0.7:1502"_s);
        QCOMPARE(form.check()->host, u"10.0.0.7"_s);
        QVERIFY(find<QRadioButton>(form, "kindEthernet")->isChecked());
    }

    // --- The connection dialog

    void connectsEveryAddressOnceTheFirstAnswers()
    {
        for (const int unit : {1, 2, 4})
            m_links->place(urlOf(unit));
        ConnectDialog dialog(*m_workspace, RecentConnections(*m_settings), &m_ports);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        click(dialog, "kindSerial");
        type(dialog, "units", u"1-2, 4"_s);
        picture(dialog, u"connect-rs485"_s);
        click(dialog, "connectButton");
        QVERIFY(!dialog.isVisible());
        QCOMPARE(m_workspace->sessions().size(), 3);
        for (const auto* session : m_workspace->sessions())
            QVERIFY(session->isReady());
        QCOMPARE(m_workspace->current()->url().unit, 1);
        QCOMPARE(RecentConnections(*m_settings).list().size(), 3);
        QCOMPARE(RecentConnections(*m_settings).list().first().url, urlOf(1));
    }

    void nobodyThereIsSaidAndNothingIsKept()
    {
        ConnectDialog dialog(*m_workspace, RecentConnections(*m_settings), &m_ports);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        click(dialog, "kindSerial");
        type(dialog, "units", u"5, 6"_s);
        click(dialog, "connectButton");
        QVERIFY(dialog.isVisible());
        QVERIFY(!text(dialog, "connectState").isEmpty());
        QCOMPARE(find<QLineEdit>(dialog, "units")->text(), u"5, 6"_s);
        picture(dialog, u"connect-rs485-failed"_s);
        dialog.reject();
        settle();
        QVERIFY(m_workspace->sessions().isEmpty());
    }

    void recentConnectionsOfBothKindsAreOffered()
    {
        RecentConnections recent(*m_settings);
        ports::ConnectionUrl tcp;
        tcp.host = u"10.0.0.7"_s;
        recent.add({tcp, u"Left"_s});
        recent.add({urlOf(3), u"Right"_s});
        recent.add({urlOf(3, {9'600, SerialParity::None}), u"Right"_s}); // the same sensor
        QCOMPARE(recent.list().size(), 2);
        ConnectDialog dialog(*m_workspace, recent, &m_ports);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        QVERIFY(find<QRadioButton>(dialog, "kindSerial")->isChecked()); // the newest fills the form
        QCOMPARE(find<ConnectionForm>(dialog, "connectionForm")->check(),
                 std::optional(urlOf(3, {9'600, SerialParity::None})));
        auto* list = find<QAbstractItemView>(dialog, "recentList");
        list->setCurrentIndex(list->model()->index(1, 0));
        QVERIFY(find<QRadioButton>(dialog, "kindEthernet")->isChecked());
        picture(dialog, u"connect-recent"_s);
    }

    void theScanButtonHandsThePortOver()
    {
        ConnectDialog dialog(*m_workspace, RecentConnections(*m_settings), &m_ports);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        click(dialog, "kindSerial");
        find<PortBox>(dialog, "serialPort")->setPort(u"COM7"_s);
        QSignalSpy asked(&dialog, &ConnectDialog::scanRequested);
        click(dialog, "scanButton");
        QCOMPARE(asked.count(), 1);
        QCOMPARE(asked.first().first().toString(), u"COM7"_s);
        QVERIFY(!dialog.isVisible());
    }

    // --- The scan

    void asksForThePlanOfTheFields()
    {
        auto dialog = openScan();
        click(*dialog, "scanButton");
        QCOMPARE(m_scans.latest->plan.port, u"/dev/ttyUSB0"_s);
        QCOMPARE(m_scans.latest->plan.settings, ports::usualSerialSettings());
        QCOMPARE(int(m_scans.latest->plan.firstUnit), 1);
        QCOMPARE(int(m_scans.latest->plan.lastUnit), 247);
        click(*dialog, "scanButton"); // Stop
        QCOMPARE(m_scans.latest->cancels, 1);
        click(*dialog, "everySettings");
        find<QSpinBox>(*dialog, "firstUnit")->setValue(4);
        find<QSpinBox>(*dialog, "lastUnit")->setValue(20);
        click(*dialog, "scanButton");
        QCOMPARE(m_scans.latest->plan.settings, ports::everySerialSettings());
        QCOMPARE(int(m_scans.latest->plan.firstUnit), 4);
        QCOMPARE(int(m_scans.latest->plan.lastUnit), 20);
    }

    void showsProgressFindingsAndWhatToDo()
    {
        connected(2);
        auto dialog = openScan();
        picture(*dialog, u"scan-before"_s);
        click(*dialog, "scanButton");
        m_scheduler.advanceMs(10'000);
        ports::ScanProgress progress{100, 500, {38'400, SerialParity::Even}, 101};
        Q_EMIT m_scans.latest->progressed(progress);
        settle();
        QVERIFY2(text(*dialog, "scanState").contains(u"address 101"_s),
                 qPrintable(text(*dialog, "scanState")));
        QVERIFY2(text(*dialog, "scanState").contains(u"41 s left"_s), qPrintable(text(*dialog, "scanState")));
        for (const ScanFinding& finding :
             {ScanFinding{Kind::Sensor, {}, 1}, ScanFinding{Kind::Sensor, {}, 2},
              ScanFinding{Kind::OtherDevice, {}, 9}, ScanFinding{Kind::TwoUnits, {}, 12},
              ScanFinding{Kind::Noise, {9'600, SerialParity::Even}, 0}})
            Q_EMIT m_scans.latest->found(finding);
        settle();
        auto* table = find<QTableView>(*dialog, "scanFindings");
        QCOMPARE(table->model()->rowCount(), 5);
        QCOMPARE(find<QPushButton>(*dialog, "addButton")->text(), u"&Add 1 sensor"_s); // 2 is in the list
        QCOMPARE(table->model()->index(1, 3).data().toString(), u"in the list"_s);
        table->selectRow(3);
        QVERIFY(text(*dialog, "scanAdvice").contains(u"menu 82"_s));
        picture(*dialog, u"scan-running"_s);
        Q_EMIT m_scans.latest->finished(ScanEnd::Complete, {});
        settle();
        QVERIFY(find<QPushButton>(*dialog, "addButton")->property("primary").toBool());
        QVERIFY(!find<QPushButton>(*dialog, "scanButton")->property("primary").toBool());
        picture(*dialog, u"scan-done"_s);
    }

    void addsWhatIsTicked()
    {
        for (const int unit : {1, 3, 5})
            m_links->place(urlOf(unit));
        auto dialog = openScan();
        click(*dialog, "scanButton");
        for (const int unit : {1, 3, 5})
            Q_EMIT m_scans.latest->found({Kind::Sensor, {}, quint8(unit)});
        Q_EMIT m_scans.latest->finished(ScanEnd::Complete, {});
        settle();
        auto* table = find<QTableView>(*dialog, "scanFindings");
        table->setCurrentIndex(table->model()->index(1, 0));
        QTest::keyClick(table, Qt::Key_Space); // by keys
        QCOMPARE(find<QPushButton>(*dialog, "addButton")->text(), u"&Add 2 sensors"_s);
        QSignalSpy added(dialog.get(), &ScanDialog::sensorAdded);
        click(*dialog, "addButton");
        QCOMPARE(added.count(), 2);
        QVERIFY(!dialog->isVisible());
        QList<int> units;
        for (const auto* session : m_workspace->sessions()) {
            QVERIFY(session->isReady());
            units.append(session->url().unit);
        }
        QCOMPARE(units, (QList{1, 5}));
        QVERIFY(!m_scans.latest); // the port is free
    }

    void aSensorOfTheListFoundWithOtherSettingsGoesThere()
    {
        auto* session = m_workspace->add(urlOf(4, {9'600, SerialParity::Even}));
        session->edit({{ItemId::HighSetValue, 12'340}});
        m_links->place(urlOf(4));
        auto dialog = openScan();
        click(*dialog, "scanButton");
        Q_EMIT m_scans.latest->found({Kind::Sensor, {}, 4});
        Q_EMIT m_scans.latest->finished(ScanEnd::Complete, {});
        settle();
        click(*dialog, "addButton");
        QCOMPARE(m_workspace->sessions().size(), 1);
        QCOMPARE(session->url(), urlOf(4));
        QVERIFY(session->isReady());
        QCOMPARE(session->pending().count(), 1);
    }

    void aPortThatFailsIsSaidInASentence()
    {
        auto dialog = openScan();
        click(*dialog, "scanButton");
        Q_EMIT m_scans.latest->finished(ScanEnd::PortFailed, u"Permission denied"_s);
        settle();
        QVERIFY(text(*dialog, "scanState").contains(u"/dev/ttyUSB0"_s));
        QVERIFY(text(*dialog, "scanState").contains(u"Permission denied"_s));
        QVERIFY(find<PortBox>(*dialog, "scanPort")->isEnabled());
        picture(*dialog, u"scan-failed"_s);
    }

    void closingTheDialogEndsTheScan()
    {
        auto dialog = openScan();
        click(*dialog, "scanButton");
        QVERIFY(m_scans.latest);
        QTest::keyClick(dialog.get(), Qt::Key_Escape);
        settle();
        QVERIFY(!dialog->isVisible());
        QVERIFY(!m_scans.latest);
    }

    // --- The guided change

    void theChangeShowsItsStepsAndEndsWhereItWanted()
    {
        auto* session = connected(1);
        auto& device = m_links->sensor(urlOf(1));
        const ports::ConnectionUrl target = urlOf(7, {115'200, SerialParity::Odd});
        device.setOnRequest([&](const ports::Request& request) {
            if (!request.write.isEmpty() &&
                request.write.first().item == ItemId::ResettingCommunicationSettings)
                m_links->move(urlOf(1), target);
        });
        ChangeCommunicationDialog dialog(*session, *m_workspace, *m_links, m_scheduler);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        auto* change = find<QPushButton>(dialog, "changeButton");
        QVERIFY(!change->isEnabled()); // nothing to change yet
        find<QSpinBox>(dialog, "newUnit")->setFocus();
        QTest::keyClicks(find<QSpinBox>(dialog, "newUnit"), u"7"_s);
        find<QComboBox>(dialog, "newSpeed")->setCurrentText(u"115200 bps"_s);
        find<QComboBox>(dialog, "newParity")->setCurrentText(u"ODD + 1bit"_s);
        QVERIFY(change->isEnabled());
        picture(dialog, u"change-before"_s);
        QSignalSpy moved(&dialog, &ChangeCommunicationDialog::moved);
        device.holdAnswers(true);
        QTest::keyClick(&dialog, Qt::Key_Return);
        settle();
        QVERIFY(dialog.change().isRunning());
        QVERIFY(!find<QSpinBox>(dialog, "newUnit")->isEnabled());
        for (int answered = 0; answered < 5; ++answered) {
            device.deliver();
            settle();
        }
        picture(dialog, u"change-running"_s);
        device.holdAnswers(false);
        device.deliverAll();
        settle();
        QCOMPARE(dialog.change().state(), State::Done);
        QCOMPARE(session->url(), target);
        QCOMPARE(moved.count(), 1);
        QVERIFY2(text(dialog, "changeSentence").contains(u"address 7 with 115200 bps"_s),
                 qPrintable(text(dialog, "changeSentence")));
        picture(dialog, u"change-done"_s);
        QTest::keyClick(&dialog, Qt::Key_Return);
        QVERIFY(!dialog.isVisible());
    }

    void afterAFailureItSaysWhereTheSensorIsAndGoesBack()
    {
        auto* session = connected(1);
        auto& device = m_links->sensor(urlOf(1));
        device.refuse(ItemId::ParityStopBit);
        ChangeCommunicationDialog dialog(*session, *m_workspace, *m_links, m_scheduler);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        find<QSpinBox>(dialog, "newUnit")->setValue(7);
        find<QComboBox>(dialog, "newSpeed")->setCurrentText(u"115200 bps"_s);
        find<QComboBox>(dialog, "newParity")->setCurrentText(u"ODD + 1bit"_s);
        click(dialog, "changeButton");
        QCOMPARE(dialog.change().state(), State::Failed);
        const QString sentence = text(dialog, "changeSentence");
        QVERIFY2(sentence.contains(u"Parity"_s) && sentence.contains(u"address 1 with 38400 bps"_s),
                 qPrintable(sentence));
        QVERIFY(find<QPushButton>(dialog, "backButton")->isVisible());
        picture(dialog, u"change-failed"_s);
        click(dialog, "backButton");
        QCOMPARE(dialog.change().state(), State::WentBack);
        QCOMPARE(device.value(ItemId::CommunicationSpeed), *ports::speedCode(38'400));
    }

    void aSensorThatIsGoneCanBeSearchedAgain()
    {
        auto* session = connected(1);
        auto& device = m_links->sensor(urlOf(1));
        device.setOnRequest([&](const ports::Request& request) {
            if (!request.write.isEmpty() &&
                request.write.first().item == ItemId::ResettingCommunicationSettings)
                m_links->move(urlOf(1), urlOf(200));
        });
        ChangeCommunicationDialog dialog(*session, *m_workspace, *m_links, m_scheduler);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        find<QSpinBox>(dialog, "newUnit")->setValue(7);
        click(dialog, "changeButton");
        QCOMPARE(dialog.change().state(), State::Reopening);
        QCOMPARE(find<QPushButton>(dialog, "closeButton")->text(), u"&Stop waiting"_s);
        picture(dialog, u"change-waiting"_s);
        pass(16'300);
        QVERIFY(find<QPushButton>(dialog, "searchButton")->isVisible());
        picture(dialog, u"change-lost"_s);
        m_links->move(urlOf(200), urlOf(1));
        click(dialog, "searchButton");
        pass(8'300);
        QVERIFY(text(dialog, "changeSentence").contains(u"former"_s));
        QVERIFY(find<QPushButton>(dialog, "backButton")->isVisible());
    }

    void anAddressThatIsTakenIsSaidBesideTheFields()
    {
        auto* session = connected(1);
        connected(2);
        ChangeCommunicationDialog dialog(*session, *m_workspace, *m_links, m_scheduler);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        find<QSpinBox>(dialog, "newUnit")->setValue(2);
        QVERIFY(text(dialog, "changeProblem").contains(u'2'));
        QVERIFY(!find<QPushButton>(dialog, "changeButton")->isEnabled());
        find<QSpinBox>(dialog, "newUnit")->setValue(3);
        QVERIFY(!find<QLabel>(dialog, "changeProblem")->isVisible());
        find<QComboBox>(dialog, "newSpeed")->setCurrentText(u"9600 bps"_s);
        QVERIFY(!find<QPushButton>(dialog, "changeButton")->isEnabled()); // the other one keeps its speed
        picture(dialog, u"change-others"_s);
    }

    void escapeWhileItWritesPutsBack()
    {
        auto* session = connected(1);
        auto& device = m_links->sensor(urlOf(1));
        ChangeCommunicationDialog dialog(*session, *m_workspace, *m_links, m_scheduler);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        find<QComboBox>(dialog, "newSpeed")->setCurrentText(u"9600 bps"_s);
        device.holdAnswers(true);
        click(dialog, "changeButton");
        while (device.writes() == 0) {
            device.deliver();
            settle();
        }
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QVERIFY(dialog.isVisible());
        device.holdAnswers(false);
        device.deliverAll();
        settle();
        QCOMPARE(dialog.change().state(), State::WentBack);
        QCOMPARE(device.value(ItemId::CommunicationSpeed), *ports::speedCode(38'400));
    }
};

QTEST_MAIN(SerialDialogsTest)
#include "tst_serial_dialogs.moc"
