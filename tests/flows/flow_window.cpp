// A person's day with the window: connect, edit, review, apply, save, close; and what goes wrong on the
// way. Mouse and keys on one side, the virtual sensor behind a real socket on the other.

#include "window_fixture.h"

#include "banner.h"
#include "readout.h"
#include "readout_state.h"

#include <QComboBox>
#include <QDialog>
#include <QListView>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTreeView>

using namespace lds;
using namespace lds::flows;
using namespace Qt::StringLiterals;
using emulator::Fault;
using emulator::FaultOn;
using sensor::Connection;

class WindowFlow : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowFixture> f;

    QDialog* dialog(const char* name) const
    {
        for (QDialog* each : f->window->findChildren<QDialog*>(QLatin1StringView(name))) {
            if (each->isVisible())
                return each;
        }
        return nullptr;
    }

    /// The dialog by its key, filled in by keys.
    QDialog* openConnect(const QString& host, const QString& port)
    {
        QTest::keyClick(f->window.get(), Qt::Key_K, Qt::ControlModifier);
        QDialog* connect = dialog("connectDialog");
        if (!connect)
            return nullptr;
        f->type(f->find<QLineEdit>("host", connect), host);
        f->type(f->find<QLineEdit>("port", connect), port);
        return connect;
    }

    void connectSensor()
    {
        QTRY_VERIFY(f->device->port() != 0);
        QDialog* connect = openConnect(u"127.0.0.1"_s, QString::number(f->device->port()));
        QVERIFY(connect);
        f->find<QComboBox>("type", connect)->setCurrentIndex(1); // HL-G203B-S-MK
        f->type(f->find<QLineEdit>("name", connect), u"Press 3, left"_s);
        QTest::keyClick(connect, Qt::Key_Return);
        QTRY_VERIFY(f->session() && f->session()->isReady());
        QTRY_VERIFY(!dialog("connectDialog"));
        f->activate();
    }

    /// Filters to one row, goes there and types a value, as a person without a mouse does.
    void editByKeys(const QString& filter, ItemId item, const QString& text)
    {
        f->activate();
        QCoreApplication::processEvents(); // a row whose editor has just closed stays in sight until now
        QTest::keyClick(f->window.get(), Qt::Key_F, Qt::ControlModifier);
        auto* box = f->find<QLineEdit>("filter");
        QVERIFY(box);
        f->type(box, filter);
        auto* tree = f->find<QTreeView>("settingsTree");
        QTest::keyClick(box, Qt::Key_Return);
        QTest::keyClick(tree, Qt::Key_Home);
        QTest::keyClick(tree, Qt::Key_Down);
        QTest::keyClick(tree, Qt::Key_F2);
        QWidget* editor = QApplication::focusWidget();
        QVERIFY(editor && editor != tree);
        QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(editor, text);
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(f->session()->pending().find(item));
        box->clear();
    }

    ui::Banner* banner(const char* subject) const
    {
        auto* found = f->window->findChild<ui::Banner*>(u"banner."_s + QLatin1StringView(subject));
        return found && found->isVisible() ? found : nullptr;
    }

    QString said() const { return f->find<QLabel>("said")->text(); }

private Q_SLOTS:
    void init() { f = std::make_unique<WindowFixture>(); }
    void cleanup() { f.reset(); }

    void connectEditReviewApplySaveClose()
    {
        connectSensor();
        QCOMPARE(f->session()->name(), u"Press 3, left"_s);
        QCOMPARE(f->find<QLabel>("connectionWord")->text(), u"Connected"_s);
        QTRY_VERIFY(f->find<ui::Readout>("readout")->state().isLive);

        const Value highBefore = f->holds(ItemId::HighSetValue);
        editByKeys(u"31 high"_s, ItemId::HighSetValue, u"1.75"_s);
        editByKeys(u"32 low"_s, ItemId::LowSetValue, u"-1.25"_s);
        QCOMPARE(f->holds(ItemId::HighSetValue), highBefore); // nothing is written by editing
        auto* review = f->find<QAbstractButton>("button.review");
        QCOMPARE(review->text(), u"Review and apply (2)"_s);

        f->click(review);
        QDialog* open = dialog("reviewDialog");
        QVERIFY(open);
        f->click(f->find<QAbstractButton>("applyButton", open));
        QTRY_COMPARE(f->session()->pending().count(), 0);
        QTRY_VERIFY(!dialog("reviewDialog"));
        QCOMPARE(f->holds(ItemId::HighSetValue), 17'500);
        QCOMPARE(f->holds(ItemId::LowSetValue), -12'500);
        QCOMPARE(f->writesOf(ItemId::HighSetValue), 1);
        QVERIFY2(said().contains(u"2 change"_s), qPrintable(said()));

        // RAM is not memory: the sign stays until it is saved.
        QCOMPARE(f->session()->saved(), sensor::Saved::NotSaved);
        QVERIFY(f->hasSaved(ItemId::HighSetValue) != 17'500);
        f->activate();
        QTRY_VERIFY(f->action("saveInSensor")->isEnabled());
        QTest::keyClick(f->window.get(), Qt::Key_S, Qt::ControlModifier);
        QTRY_COMPARE(f->session()->saved(), sensor::Saved::Saved);
        QCOMPARE(f->hasSaved(ItemId::HighSetValue), 17'500);
        QCOMPARE(said(), u"Saved in the sensor."_s);

        QVERIFY(f->window->close()); // nothing left behind: no question
    }

    void undoAndRedoByKeys()
    {
        connectSensor();
        editByKeys(u"31 high"_s, ItemId::HighSetValue, u"1.75"_s);
        f->window->setFocus();
        QTest::keyClick(f->window.get(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(f->session()->pending().isEmpty());
        QTest::keyClick(f->window.get(), Qt::Key_Y, Qt::ControlModifier);
        QCOMPARE(f->session()->pending().find(ItemId::HighSetValue)->wanted, 17'500);
    }

    void closingWithEditsAsksAndCancelIsTheDefault()
    {
        connectSensor();
        editByKeys(u"31 high"_s, ItemId::HighSetValue, u"1.75"_s);
        QVERIFY(!f->window->close());
        auto* question = f->find<QMessageBox>("leaveQuestion");
        QVERIFY(question && question->isVisible());
        QVERIFY2(question->informativeText().contains(u"Press 3, left"_s),
                 qPrintable(question->informativeText()));
        QTest::keyClick(question, Qt::Key_Return); // the default: stay
        QTRY_VERIFY(!f->find<QMessageBox>("leaveQuestion"));
        QVERIFY(f->window->isVisible());
        QCOMPARE(f->session()->pending().count(), 1);

        QVERIFY(!f->window->close());
        f->click(f->find<QAbstractButton>("leaveButton"));
        QTRY_VERIFY(!f->window->isVisible());
        QCOMPARE(f->writesOf(ItemId::HighSetValue), 0);
    }

    void aWrongPortIsToldBesideTheFieldAndNothingIsLost()
    {
        QDialog* connect = openConnect(u"127.0.0.1"_s, u"70000"_s);
        QVERIFY(connect);
        QTest::keyClick(connect, Qt::Key_Return);
        auto* error = f->find<QLabel>("portError", connect);
        QVERIFY(error->isVisible());
        QVERIFY2(error->text().contains(u"65535"_s), qPrintable(error->text()));
        QCOMPARE(f->find<QLineEdit>("host", connect)->text(), u"127.0.0.1"_s);
        QCOMPARE(f->find<QLineEdit>("port", connect)->text(), u"70000"_s);
        QVERIFY(f->workspace.sessions().isEmpty());
        QTest::keyClick(connect, Qt::Key_Escape);
        QTRY_VERIFY(!dialog("connectDialog"));
    }

    void aPortNobodyListensOnFailsInTheDialogAndCanBeCorrectedThere()
    {
        QTcpServer closed;
        QVERIFY(closed.listen(QHostAddress::LocalHost));
        const quint16 port = closed.serverPort();
        closed.close();
        QDialog* connect = openConnect(u"127.0.0.1"_s, QString::number(port));
        QTest::keyClick(connect, Qt::Key_Return);
        auto* state = f->find<QLabel>("connectState", connect);
        QTRY_VERIFY2(state->text().contains(u"refused the connection"_s), qPrintable(state->text()));
        auto* button = f->find<QAbstractButton>("connectButton", connect);
        QTRY_VERIFY(button->isEnabled());
        QVERIFY(button->text().contains(u"Retry"_s));

        QTRY_VERIFY(f->device->port() != 0);
        f->type(f->find<QLineEdit>("port", connect), QString::number(f->device->port()));
        f->click(button);
        QTRY_VERIFY(f->session() && f->session()->isReady());
        QCOMPARE(f->workspace.sessions().size(), 1); // the failed attempt left nothing behind
    }

    void cancellingAFailedConnectionLeavesNoSensor()
    {
        QTcpServer closed;
        QVERIFY(closed.listen(QHostAddress::LocalHost));
        const quint16 port = closed.serverPort();
        closed.close();
        QDialog* connect = openConnect(u"127.0.0.1"_s, QString::number(port));
        QTest::keyClick(connect, Qt::Key_Return);
        QTRY_VERIFY(f->find<QAbstractButton>("connectButton", connect)->text().contains(u"Retry"_s));
        QTest::keyClick(connect, Qt::Key_Escape);
        QTRY_VERIFY(f->workspace.sessions().isEmpty());
    }

    void somethingThatIsNoSensorIsSaid()
    {
        QTcpServer stranger; // takes the connection and hangs up
        QVERIFY(stranger.listen(QHostAddress::LocalHost));
        QObject::connect(&stranger, &QTcpServer::newConnection, &stranger, [&stranger] {
            while (QTcpSocket* socket = stranger.nextPendingConnection()) {
                socket->disconnectFromHost();
                socket->deleteLater();
            }
        });
        QDialog* connect = openConnect(u"127.0.0.1"_s, QString::number(stranger.serverPort()));
        QTest::keyClick(connect, Qt::Key_Return);
        auto* button = f->find<QAbstractButton>("connectButton", connect);
        QTRY_VERIFY(button->text().contains(u"Retry"_s));
        QVERIFY(!f->find<QLabel>("connectState", connect)->text().isEmpty());
    }

    void aRefusedWriteStaysWithItsSentenceAndTheRestIsDone()
    {
        connectSensor();
        editByKeys(u"31 high"_s, ItemId::HighSetValue, u"1.75"_s);
        editByKeys(u"27 offset"_s, ItemId::Offset, u"0.5"_s);
        f->device->post(
            [](SensorStation& station) { station.sensor().setWriteFailure(ItemId::Offset, true); });
        QTest::keyClick(f->window.get(), Qt::Key_Return, Qt::ControlModifier);
        QDialog* review = dialog("reviewDialog");
        QVERIFY(review);
        QTest::keyClick(review, Qt::Key_Return);
        auto* summary = f->find<QLabel>("applySummary", review);
        QTRY_VERIFY(summary->isVisible());
        QVERIFY2(summary->text().contains(u"Offset"_s), qPrintable(summary->text()));
        QCOMPARE(f->holds(ItemId::HighSetValue), 17'500);
        QCOMPARE(f->session()->pending().count(), 1);
        QVERIFY(f->session()->pending().find(ItemId::Offset));
        QVERIFY(review->isVisible());

        f->device->post(
            [](SensorStation& station) { station.sensor().setWriteFailure(ItemId::Offset, false); });
        auto* apply = f->find<QAbstractButton>("applyButton", review);
        QTRY_VERIFY(apply->isEnabled());
        f->click(apply);
        QTRY_VERIFY(!dialog("reviewDialog"));
        QCOMPARE(f->holds(ItemId::Offset), 5'000);
    }

    void aWindowThatBreaksARuleCannotBeAppliedAndLeadsToTheRow()
    {
        connectSensor();
        editByKeys(u"31 high"_s, ItemId::HighSetValue, u"-6"_s); // below LOW
        QTest::keyClick(f->window.get(), Qt::Key_Return, Qt::ControlModifier);
        QDialog* review = dialog("reviewDialog");
        QVERIFY(review);
        QVERIFY(!f->find<QAbstractButton>("applyButton", review)->isEnabled());
        auto* jump = f->find<QAbstractButton>("jumpButton", review);
        QVERIFY(jump);
        f->click(jump);
        QTRY_VERIFY(!dialog("reviewDialog"));
        auto* tree = f->find<QTreeView>("settingsTree");
        QVERIFY(tree->currentIndex().isValid());
        QCOMPARE(f->writesOf(ItemId::HighSetValue), 0);
    }

    void aCutConnectionIsSaidEditsStayAndItComesBack()
    {
        connectSensor();
        editByKeys(u"31 high"_s, ItemId::HighSetValue, u"1.75"_s);
        const quint16 port = f->device->port();
        f->device->runAndWait([](SensorStation& station) { station.modbusServer().close(); });
        QTRY_COMPARE(f->session()->connection(), Connection::Reconnecting);
        QTRY_VERIFY(banner("connection"));
        QVERIFY(!f->find<ui::Readout>("readout")->state().isLive);
        QVERIFY(!f->find<QAbstractButton>("button.saveInSensor")->isEnabled());
        QCOMPARE(f->session()->pending().count(), 1);

        f->device->runAndWait([port](SensorStation& station) {
            const auto listening = station.modbusServer().listen(QHostAddress::LocalHost, port);
            Q_ASSERT(listening);
        });
        f->click(f->find<QAbstractButton>("bannerAction", banner("connection"))); // Try now
        QTRY_VERIFY_WITH_TIMEOUT(f->session()->isReady(), 20'000);
        QTRY_VERIFY(!banner("connection"));
        QCOMPARE(f->session()->pending().find(ItemId::HighSetValue)->wanted, 17'500);
        QCOMPARE(f->writesOf(ItemId::HighSetValue), 0); // reconnecting writes nothing
    }

    void aSensorInItsMenuIsSaidAndGoesOnAfterwards()
    {
        connectSensor();
        f->device->post([](SensorStation& station) { station.sensor().setInMenu(true); });
        QTRY_VERIFY(banner("readiness"));
        QVERIFY(!f->find<QAbstractButton>("button.saveInSensor")->isEnabled());
        f->device->post([](SensorStation& station) { station.sensor().setInMenu(false); });
        QTRY_VERIFY(!banner("readiness"));
        QTRY_VERIFY(f->find<ui::Readout>("readout")->state().isLive);
    }

    void aStoppedLaserIsSaidAndSwitchedOnFromThere()
    {
        connectSensor();
        auto* laser = f->find<QAbstractButton>("button.laser");
        QTRY_COMPARE(laser->text(), u"Laser: on"_s);
        f->click(laser);
        QTRY_VERIFY(banner("laser"));
        QCOMPARE(f->holds(ItemId::LaserStop), 1);
        QTRY_COMPARE(laser->text(), u"Laser: off"_s);
        QTRY_COMPARE(f->find<ui::Readout>("readout")->state().notice, u"The laser is stopped"_s);
        QTRY_VERIFY(laser->isEnabled());
        f->click(f->find<QAbstractButton>("bannerAction", banner("laser")));
        QTRY_VERIFY(!banner("laser"));
        QCOMPARE(f->holds(ItemId::LaserStop), 0);
    }

    void aBankSwitchedByThePlcIsSaid()
    {
        connectSensor();
        f->device->post(
            [](SensorStation& station) { station.sensor().changeByKeypad(ItemId::BankSwitching, 2); });
        QTRY_VERIFY_WITH_TIMEOUT(banner("bank"), 15'000);
        QVERIFY2(banner("bank")->text().startsWith(u"Bank 2"_s), qPrintable(banner("bank")->text()));
        QTRY_COMPARE(f->find<QLabel>("bankText")->text(), u"Bank 2"_s);
        f->click(f->find<QAbstractButton>("bannerClose", banner("bank")));
        QVERIFY(!banner("bank"));
    }

    void anEditUnderWhichTheSensorChangedIsAConflictThatThePersonDecides()
    {
        connectSensor();
        editByKeys(u"32 low"_s, ItemId::LowSetValue, u"-1"_s);
        f->device->post(
            [](SensorStation& station) { station.sensor().changeByKeypad(ItemId::LowSetValue, -20'000); });
        QTRY_VERIFY_WITH_TIMEOUT(banner("conflict"), 15'000);
        f->click(f->find<QAbstractButton>("bannerAction", banner("conflict")));
        QDialog* review = dialog("reviewDialog");
        QVERIFY(review);
        f->click(f->find<QAbstractButton>("keepMineButton", review));
        QTRY_VERIFY(!banner("conflict"));
        f->click(f->find<QAbstractButton>("applyButton", review));
        QTRY_COMPARE(f->holds(ItemId::LowSetValue), -10'000);
    }

    void aTypeThatDoesNotFitIsSaidAndCanBeCorrected()
    {
        f = nullptr;
        f = std::make_unique<WindowFixture>(catalog::SensorModel::HlG225);
        f->device->post(
            [](SensorStation& station) { station.sensor().changeByKeypad(ItemId::HighSetValue, 5'000'000); });
        connectSensor(); // as HL-G203
        QTRY_VERIFY(banner("model"));
        QVERIFY2(banner("model")->text().contains(u"HL-G225"_s), qPrintable(banner("model")->text()));
        f->action("types.4")->trigger();
        QTRY_VERIFY(!banner("model"));
        QCOMPARE(f->session()->model(), catalog::SensorModel::HlG225);
    }

    void initialisingAsksFirstAndZeroSettingDoesNot()
    {
        connectSensor();
        QTRY_VERIFY(f->action("zeroSet")->isEnabled());
        QTest::keyClick(f->window.get(), Qt::Key_F8);
        QTRY_COMPARE(f->holds(ItemId::ZeroSetting), 1);
        QTRY_VERIFY(f->find<ui::Readout>("readout")->state().zero);

        QTRY_VERIFY(f->action("initializations.1")->isEnabled());
        f->action("initializations.1")->trigger();
        auto* question = f->find<QMessageBox>("commandQuestion");
        QVERIFY(question && question->isVisible());
        QTest::keyClick(question, Qt::Key_Return); // the default: no
        QTRY_VERIFY(!f->find<QMessageBox>("commandQuestion"));
        QCOMPARE(f->holds(ItemId::ZeroSetting), 1);

        f->action("initializations.1")->trigger();
        f->click(f->find<QAbstractButton>("goButton"));
        QTRY_COMPARE(f->holds(ItemId::ZeroSetting), 0);
    }

    void aSaveThatIsNotAnsweredIsSaidAndNotRepeated()
    {
        connectSensor();
        const int before = f->device->ask([](SensorStation& s) { return s.sensor().memoryWriteCount(); });
        f->device->runAndWait([](SensorStation& station) {
            station.modbusServer().injectFault(Fault::CloseAfterCarryOut, FaultOn::Writes);
        });
        QTRY_VERIFY(f->action("saveInSensor")->isEnabled());
        f->click(f->find<QAbstractButton>("button.saveInSensor"));
        QTRY_VERIFY(banner("failure"));
        QTRY_VERIFY_WITH_TIMEOUT(f->session()->isReady(), 20'000);
        QCOMPARE(f->device->ask([](SensorStation& s) { return s.sensor().memoryWriteCount(); }), before + 1);
        QVERIFY(f->session()->saved() != sensor::Saved::Saved);
    }

    void recentConnectionsAreOfferedAgain()
    {
        connectSensor();
        QTest::keyClick(f->window.get(), Qt::Key_K, Qt::ControlModifier);
        QDialog* connect = dialog("connectDialog");
        QVERIFY(connect);
        QCOMPARE(f->find<QLineEdit>("port", connect)->text(), QString::number(f->device->port()));
        QCOMPARE(f->find<QLineEdit>("name", connect)->text(), u"Press 3, left"_s);
        QTest::keyClick(connect, Qt::Key_Escape);
    }

    void removingASensorWithEditsAsks()
    {
        connectSensor();
        editByKeys(u"31 high"_s, ItemId::HighSetValue, u"1.75"_s);
        auto* list = f->find<QListView>("sensorList");
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Delete);
        auto* question = f->find<QMessageBox>("leaveQuestion");
        QVERIFY(question && question->isVisible());
        f->click(f->find<QAbstractButton>("leaveButton"));
        QTRY_VERIFY(f->workspace.sessions().isEmpty());
        QVERIFY(f->find<QWidget>("emptyPage")->isVisible());
    }

    void pagesThemesAndAccessibleNamesAreThere()
    {
        connectSensor();
        for (const Qt::Key key : {Qt::Key_2, Qt::Key_3, Qt::Key_1}) {
            QTest::keyClick(f->window.get(), key, Qt::ControlModifier);
            QCOMPARE(f->find<QTabWidget>("pages")->currentIndex(), int(key) - int(Qt::Key_1));
        }
        f->action("theme.2")->trigger();
        QVERIFY(ui::Theme::instance().isDark());
        QCOMPARE(f->settings.value(u"view/theme"_s).toInt(), 2);
        f->action("theme.1")->trigger();
        for (auto* button : f->window->findChildren<QAbstractButton*>()) {
            if (button->isVisibleTo(f->window.get()) && button->focusPolicy() != Qt::NoFocus)
                QVERIFY2(!button->accessibleName().isEmpty() || !button->text().isEmpty(),
                         qPrintable(button->objectName()));
        }
    }
};

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    ui::Theme::instance().apply(application, ui::ThemeMode::Light);
    ports::registerMetaTypes();
    WindowFlow test;
    return QTest::qExec(&test, argc, argv);
}
#include "flow_window.moc"
