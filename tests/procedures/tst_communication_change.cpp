#include "communication_change.h"
#include "fake_link.h"
#include "manual_scheduler.h"
#include "serial_choices.h"

#include <QSignalSpy>
#include <QtTest>

using namespace lds;
using catalog::ItemId;
using catalog::Value;
using ports::ConnectionUrl;
using ports::SerialParity;
using ports::SerialSettings;
using procedures::ChangeProblem;
using procedures::CommunicationChange;
using sensor::Connection;
using State = CommunicationChange::State;
using Step = CommunicationChange::StepState;
using support::FakeSensor;

namespace {

const SerialSettings asDelivered{38'400, SerialParity::Even};
const SerialSettings wanted{115'200, SerialParity::Odd};

ConnectionUrl urlOf(const SerialSettings& serial, int unit)
{
    ConnectionUrl url;
    url.protocol = ports::Protocol::ModbusRtu;
    url.host = QStringLiteral("/dev/ttyUSB0");
    url.serial = serial;
    url.unit = quint8(unit);
    return url;
}

} // namespace

/// A workspace with one sensor at address 1 of a line, as delivered, connected.
class CommunicationChangeTest : public QObject {
    Q_OBJECT

    ports::ManualScheduler m_scheduler;
    std::unique_ptr<support::FakeLinkFactory> m_links;
    std::unique_ptr<sensor::Workspace> m_workspace;
    sensor::SensorSession* m_session = nullptr;
    std::unique_ptr<CommunicationChange> m_change;
    std::unique_ptr<QSignalSpy> m_ended;
    FakeSensor* m_device = nullptr;

    /// What a sensor does at a communication reset (§4.8.5): from then on it speaks as its values say.
    void letItMoveAtReset()
    {
        m_device->setOnRequest([this](const ports::Request& request) {
            for (const settings::ItemValue& written : request.write) {
                if (written.item != ItemId::ResettingCommunicationSettings)
                    continue;
                const auto serial = ports::serialSettingsOf(m_device->value(ItemId::CommunicationSpeed),
                                                            m_device->value(ItemId::ParityStopBit));
                QVERIFY(serial);
                moveDevice(urlOf(*serial, m_device->value(ItemId::DeviceAddress)));
            }
        });
    }
    void moveDevice(const ConnectionUrl& url) { m_links->move(std::exchange(m_deviceAt, url), url); }
    void pass(int ms)
    {
        for (int gone = 0; gone < ms; gone += 100) {
            m_scheduler.advanceMs(100);
            support::settle();
        }
    }
    bool begin(const SerialSettings& serial, int unit)
    {
        const bool begun = m_change->start(serial, quint8(unit));
        support::settle();
        return begun;
    }
    void compareDeviceWith(const SerialSettings& serial, int unit)
    {
        QCOMPARE(m_device->value(ItemId::CommunicationSpeed), *ports::speedCode(serial.baud));
        QCOMPARE(m_device->value(ItemId::ParityStopBit), ports::parityCode(serial.parity));
        QCOMPARE(m_device->value(ItemId::DeviceAddress), unit);
    }
    ConnectionUrl m_deviceAt;

private Q_SLOTS:
    void init()
    {
        ports::registerMetaTypes();
        m_links = std::make_unique<support::FakeLinkFactory>(m_scheduler);
        m_workspace = std::make_unique<sensor::Workspace>(*m_links, m_scheduler);
        m_deviceAt = urlOf(asDelivered, 1);
        m_device = &m_links->place(m_deviceAt);
        letItMoveAtReset();
        m_session = m_workspace->add(m_deviceAt);
        m_session->open();
        support::settle();
        QCOMPARE(m_session->connection(), Connection::Ready);
        m_device->forgetRequests();
        m_change = std::make_unique<CommunicationChange>(*m_session, *m_workspace, *m_links, m_scheduler);
        m_ended = std::make_unique<QSignalSpy>(m_change.get(), &CommunicationChange::ended);
    }
    void cleanup()
    {
        m_change.reset();
        m_workspace.reset();
        support::settle();
        m_links.reset();
    }

    void writesSavesResetsReopensAndVerifies()
    {
        QList<State> states;
        connect(m_change.get(), &CommunicationChange::changed, this, [&] {
            if (states.isEmpty() || states.last() != m_change->state())
                states.append(m_change->state());
        });
        m_session->edit({{ItemId::HighSetValue, 12'340}});
        QVERIFY(begin(wanted, 7));
        QCOMPARE(m_change->state(), State::Done);
        QCOMPARE(m_ended->count(), 1);
        states.removeAll(State::Idle);
        QCOMPARE(states, (QList{State::Checking, State::Writing, State::Saving, State::Resetting,
                                State::Reopening, State::Verifying, State::Done}));
        for (const State step : {State::Checking, State::Writing, State::Saving, State::Resetting,
                                 State::Reopening, State::Verifying})
            QCOMPARE(m_change->stepState(step), Step::Done);

        compareDeviceWith(wanted, 7);
        QCOMPARE(m_device->writesOf(ItemId::SetValueSaving), 1);
        QCOMPARE(m_device->writesOf(ItemId::ResettingCommunicationSettings), 1);
        QCOMPARE(m_session->url(), urlOf(wanted, 7));
        QCOMPARE(m_change->sensorAt(), urlOf(wanted, 7));
        QCOMPARE(m_session->connection(), Connection::Ready);
        QCOMPARE(m_session->pending().count(), 1); // what was edited and not applied is still wanted
        QVERIFY(m_session->canWrite());            // the lease is back
    }

    void onlyWhatDiffersIsWrittenAndOnlyANewAddressIsAsked()
    {
        const int linksBefore = m_links->created();
        QVERIFY(begin({9'600, SerialParity::Even}, 1));
        QCOMPARE(m_change->state(), State::Done);
        QCOMPARE(m_change->stepState(State::Checking), Step::NotNeeded);
        QCOMPARE(m_links->created() - linksBefore, 1); // to the new place only
        QCOMPARE(m_device->writesOf(ItemId::CommunicationSpeed), 1);
        QCOMPARE(m_device->writesOf(ItemId::ParityStopBit), 0);
        QCOMPARE(m_device->writesOf(ItemId::DeviceAddress), 0);
    }

    void nobodyElseIsBlamedForTheChange()
    {
        QSignalSpy external(m_session, &sensor::SensorSession::externallyChanged);
        QVERIFY(begin(wanted, 7));
        pass(20'000); // the slow walk comes round to every setting
        QCOMPARE(m_change->state(), State::Done);
        QCOMPARE(external.count(), 0);
    }

    void theLeaseIsHeldMeanwhile()
    {
        m_device->holdAnswers(true);
        QVERIFY(begin(wanted, 7));
        QVERIFY(m_change->isRunning());
        QVERIFY(!m_session->canWrite());
        QVERIFY(!m_session->apply());
        QVERIFY(!m_session->run(ItemId::SetValueSaving, 0));
        QVERIFY(!m_change->start(wanted, 7));
        m_device->holdAnswers(false);
        m_device->deliverAll();
        support::settle();
        QCOMPARE(m_change->state(), State::Done);
    }

    void anAddressInTheListIsRefusedBeforeAnythingIsWritten()
    {
        m_workspace->add(urlOf({9'600, SerialParity::None}, 7));
        QCOMPARE(m_change->obstacle(asDelivered, 7), ChangeProblem::AddressInList);
        QVERIFY(!begin(asDelivered, 7));
        QCOMPARE(m_device->writes(), 0);
        QCOMPARE(m_change->obstacle(asDelivered, 8), ChangeProblem::None);
        QCOMPARE(m_change->obstacle(asDelivered, 1), ChangeProblem::NothingToChange);
    }

    void aPortSharedWithOthersKeepsItsSpeed()
    {
        ConnectionUrl url = urlOf(asDelivered, 9);
        m_links->place(url);
        sensor::SensorSession* other = m_workspace->add(url);
        QCOMPARE(m_change->obstacle(wanted, 7), ChangeProblem::None); // it is not connected
        other->open();
        support::settle();
        QCOMPARE(m_change->obstacle(wanted, 7), ChangeProblem::OthersOnLine);
        QCOMPARE(m_change->obstacle(wanted, 1), ChangeProblem::OthersOnLine);
        QVERIFY(!begin(wanted, 7));
        QCOMPARE(m_change->obstacle(asDelivered, 7), ChangeProblem::None); // an address is no speed
        QVERIFY(begin(asDelivered, 7));
        QCOMPARE(m_change->state(), State::Done);
    }

    void anAddressThatAnswersIsRefusedBeforeAnythingIsWritten_data()
    {
        QTest::addColumn<ports::OpenFailure>("answer");
        QTest::newRow("a sensor") << ports::OpenFailure::None;
        QTest::newRow("another device") << ports::OpenFailure::NotASensor;
        QTest::newRow("a sensor in its menu") << ports::OpenFailure::NotReady;
    }
    void anAddressThatAnswersIsRefusedBeforeAnythingIsWritten()
    {
        QFETCH(ports::OpenFailure, answer);
        m_links->place(urlOf(asDelivered, 7)).failOpenings(answer);
        QVERIFY(begin(wanted, 7));
        QCOMPARE(m_change->state(), State::Failed);
        QCOMPARE(m_change->failure().problem, ChangeProblem::AddressAnswers);
        QCOMPARE(m_ended->count(), 1);
        QCOMPARE(m_device->writes(), 0);
        QCOMPARE(m_change->sensorAt(), urlOf(asDelivered, 1));
        QVERIFY(!m_change->canGoBack()); // nothing was changed
        QVERIFY(m_session->canWrite());
    }

    void whatTheSensorRefusesEndsTheWayAndCanBeTakenBack()
    {
        m_device->refuse(ItemId::DeviceAddress);
        QVERIFY(begin(wanted, 7));
        QCOMPARE(m_change->failure().problem, ChangeProblem::WriteFailed);
        QCOMPARE(m_change->failure().item, ItemId::DeviceAddress);
        QCOMPARE(m_device->writesOf(ItemId::ResettingCommunicationSettings), 0);
        QCOMPARE(m_change->sensorAt(), urlOf(asDelivered, 1));

        m_device->acceptAgain(ItemId::DeviceAddress);
        QVERIFY(m_change->canGoBack());
        m_change->goBack();
        support::settle();
        QCOMPARE(m_change->state(), State::WentBack);
        QCOMPARE(m_ended->count(), 2);
        compareDeviceWith(asDelivered, 1);
        QCOMPARE(m_device->writesOf(ItemId::SetValueSaving), 0); // nothing of it was ever saved
        QCOMPARE(m_device->writesOf(ItemId::ResettingCommunicationSettings), 0);
    }

    void aLostAnswerIsFoundOutByReadingAndNeverWrittenAgain_data()
    {
        QTest::addColumn<bool>("carriedOut");
        QTest::newRow("carried out") << true;
        QTest::newRow("not carried out") << false;
    }
    void aLostAnswerIsFoundOutByReadingAndNeverWrittenAgain()
    {
        QFETCH(bool, carriedOut);
        m_device->loseAnswer(ItemId::DeviceAddress,
                             carriedOut ? FakeSensor::Carried::Out : FakeSensor::Carried::Not);
        QVERIFY(begin(wanted, 7));
        QCOMPARE(m_change->state(), State::Writing);
        m_device->timeOut();
        support::settle();
        QCOMPARE(m_change->state(), carriedOut ? State::Done : State::Failed);
        QCOMPARE(m_device->writesOf(ItemId::DeviceAddress), 1);
        if (!carriedOut) {
            QCOMPARE(m_change->failure().problem, ChangeProblem::WriteFailed);
            QCOMPARE(m_change->failure().wire.code, ports::FailureCode::NoAnswer);
        }
    }

    void whetherItWasSavedIsNotGuessed()
    {
        m_device->loseAnswer(ItemId::SetValueSaving, FakeSensor::Carried::Out);
        QVERIFY(begin(wanted, 7));
        m_device->timeOut();
        support::settle();
        QCOMPARE(m_change->failure().problem, ChangeProblem::SaveUnknown);
        QCOMPARE(m_device->writesOf(ItemId::SetValueSaving), 1);
        QCOMPARE(m_device->writesOf(ItemId::ResettingCommunicationSettings), 0);
        QCOMPARE(m_session->saved(), sensor::Saved::Unknown);

        m_change->goBack(); // saves once more, with the former values
        support::settle();
        QCOMPARE(m_change->state(), State::WentBack);
        compareDeviceWith(asDelivered, 1);
        QCOMPARE(m_device->writesOf(ItemId::SetValueSaving), 2);
    }

    void aSensorThatIsSilentAfterSavingIsWaitedFor()
    {
        int lost = -1; // until it is saving
        m_device->setOnRequest([&](const ports::Request& request) {
            const ItemId written = request.write.isEmpty() ? ItemId::SensorState : request.write.first().item;
            if (written == ItemId::SetValueSaving)
                lost = 0;
            else if (written == ItemId::ResettingCommunicationSettings)
                moveDevice(urlOf(wanted, 7));
            else if (request.urgency == ports::Urgency::Procedure && lost >= 0 && lost++ < 3)
                m_device->loseReads(1);
        });
        QVERIFY(begin(wanted, 7));
        for (int silence = 0; silence < 3; ++silence) {
            QCOMPARE(m_change->state(), State::Saving);
            QCOMPARE(lost, silence + 1);
            m_device->timeOut();
            pass(600);
        }
        QCOMPARE(m_change->state(), State::Done);
        QCOMPARE(m_device->writesOf(ItemId::SetValueSaving), 1);
    }

    void aResetWithoutAnAnswerIsFoundOutByAskingBothSettings_data()
    {
        QTest::addColumn<bool>("carriedOut");
        QTest::newRow("it was reset") << true;
        QTest::newRow("it was not") << false;
    }
    void aResetWithoutAnAnswerIsFoundOutByAskingBothSettings()
    {
        QFETCH(bool, carriedOut);
        if (!carriedOut)
            m_device->setOnRequest({});
        m_device->loseAnswer(ItemId::ResettingCommunicationSettings, FakeSensor::Carried::Not);
        QVERIFY(begin(wanted, 7));
        QCOMPARE(m_change->state(), State::Resetting);
        m_device->timeOut();
        support::settle();
        if (carriedOut) {
            QCOMPARE(m_change->state(), State::Done);
            return;
        }
        QCOMPARE(m_change->state(), State::Reopening);
        QCOMPARE(m_session->url(), urlOf(wanted, 7));
        pass(8'100);
        QCOMPARE(m_change->state(), State::Failed);
        QCOMPARE(m_change->failure().problem, ChangeProblem::StillOld);
        QCOMPARE(m_change->sensorAt(), urlOf(asDelivered, 1));
        QCOMPARE(m_session->url(), urlOf(asDelivered, 1));
        QCOMPARE(m_device->writesOf(ItemId::ResettingCommunicationSettings), 1);
        QCOMPARE(m_ended->count(), 1);

        m_change->goBack(); // its memory has the new settings: the next time with power it would speak so
        support::settle();
        QCOMPARE(m_change->state(), State::WentBack);
        compareDeviceWith(asDelivered, 1);
        QCOMPARE(m_device->writesOf(ItemId::SetValueSaving), 2);
        QCOMPARE(m_device->writesOf(ItemId::ResettingCommunicationSettings), 1);
    }

    void aSensorThatAnswersNowhereIsSaidSoAndFoundWhenItComesBack()
    {
        m_device->setOnRequest([this](const ports::Request& request) {
            if (!request.write.isEmpty() &&
                request.write.first().item == ItemId::ResettingCommunicationSettings) {
                moveDevice(urlOf(wanted, 7));
                m_device->failOpenings(ports::OpenFailure::NoAnswer);
            }
        });
        QVERIFY(begin(wanted, 7));
        pass(16'300);
        QCOMPARE(m_change->state(), State::Failed);
        QCOMPARE(m_change->failure().problem, ChangeProblem::NoAnswer);
        QVERIFY(!m_change->sensorAt());
        QVERIFY(!m_change->canGoBack());
        QVERIFY(m_change->canSearch());
        QCOMPARE(m_session->url(), urlOf(wanted, 7));

        m_device->allowOpenings(); // its power was off and is on again
        pass(10'000);              // the session looks for it at its own pace
        QCOMPARE(m_change->state(), State::Done);
        QCOMPARE(m_ended->count(), 2);
    }

    void theSearchFindsItWithTheFormerSettingsToo()
    {
        m_device->setOnRequest([this](const ports::Request& request) {
            if (!request.write.isEmpty() &&
                request.write.first().item == ItemId::ResettingCommunicationSettings)
                moveDevice(urlOf(wanted, 200));
        });
        QVERIFY(begin(wanted, 7));
        pass(16'300);
        QVERIFY(m_change->canSearch());
        m_links->move(urlOf(wanted, 200), urlOf(asDelivered, 1));
        m_change->searchAgain();
        pass(8'300);
        QCOMPARE(m_change->failure().problem, ChangeProblem::StillOld);
        QCOMPARE(m_change->sensorAt(), urlOf(asDelivered, 1));
    }

    void anotherSensorAtTheNewPlaceIsNotTakenForThisOne()
    {
        FakeSensor* other = nullptr;
        m_device->setOnRequest([&](const ports::Request& request) {
            if (!request.write.isEmpty() &&
                request.write.first().item == ItemId::ResettingCommunicationSettings) {
                moveDevice(urlOf(wanted, 200));
                other = &m_links->place(urlOf(wanted, 7));
            }
        });
        QVERIFY(begin(wanted, 7));
        QCOMPARE(m_change->failure().problem, ChangeProblem::OtherValues);
        QVERIFY(other);
        QCOMPARE(other->writes(), 0);
    }

    void theWayBackFromTheNewSettingsResetsAgain()
    {
        m_device->setOnRequest([this](const ports::Request& request) {
            if (!request.write.isEmpty() &&
                request.write.first().item == ItemId::ResettingCommunicationSettings) {
                moveDevice(urlOf(wanted, 7));
                m_device->set(ItemId::ParityStopBit, 0); // somebody at its keys
            }
        });
        QVERIFY(begin(wanted, 7));
        QCOMPARE(m_change->failure().problem, ChangeProblem::OtherValues);
        QCOMPARE(m_change->sensorAt(), urlOf(wanted, 7));
        letItMoveAtReset();
        m_change->goBack();
        QVERIFY(m_change->isGoingBack());
        support::settle();
        QCOMPARE(m_change->state(), State::WentBack);
        QCOMPARE(m_session->url(), urlOf(asDelivered, 1));
        QCOMPARE(m_session->connection(), Connection::Ready);
        compareDeviceWith(asDelivered, 1);
    }

    void cancellingPutsBackWhatWasWritten()
    {
        m_device->holdAnswers(true);
        QVERIFY(begin(wanted, 7));
        while (m_device->writes() == 0) {
            m_device->deliver();
            support::settle();
        }
        QVERIFY(m_change->canCancel());
        m_change->cancel();
        QVERIFY(!m_change->canCancel());
        m_device->holdAnswers(false);
        m_device->deliverAll();
        support::settle();
        QCOMPARE(m_change->state(), State::WentBack);
        QCOMPARE(m_ended->count(), 1);
        compareDeviceWith(asDelivered, 1);
        QCOMPARE(m_device->writesOf(ItemId::SetValueSaving), 0);
        QVERIFY(m_session->canWrite());
    }

    void cancellingBeforeAnythingIsWrittenJustEnds()
    {
        m_device->holdAnswers(true);
        QVERIFY(begin({9'600, SerialParity::Even}, 1));
        m_change->cancel();
        m_device->holdAnswers(false);
        m_device->deliverAll();
        support::settle();
        QCOMPARE(m_change->failure().problem, ChangeProblem::Cancelled);
        QCOMPARE(m_device->writes(), 0);
    }

    void aCutOnTheWayEndsItOnceAndTheSensorIsWhereItWas()
    {
        m_device->holdAnswers(true);
        QVERIFY(begin(wanted, 7));
        while (m_device->writes() == 0) {
            m_device->deliver();
            support::settle();
        }
        m_device->cut();
        support::settle();
        QCOMPARE(m_change->failure().problem, ChangeProblem::Disconnected);
        QCOMPARE(m_ended->count(), 1);
        QVERIFY(!m_change->canGoBack()); // not connected
        m_device->holdAnswers(false);
        pass(1'000);
        QCOMPARE(m_session->connection(), Connection::Ready);
        QVERIFY(m_change->canGoBack());
    }

    void disconnectingOrRemovingTheSensorEndsIt_data()
    {
        QTest::addColumn<bool>("removed");
        QTest::newRow("disconnected") << false;
        QTest::newRow("removed") << true;
    }
    void disconnectingOrRemovingTheSensorEndsIt()
    {
        QFETCH(bool, removed);
        m_device->holdAnswers(true);
        QVERIFY(begin(wanted, 7));
        QVERIFY(m_change->isRunning());
        if (removed)
            m_workspace->remove(m_session);
        else
            m_session->close();
        support::settle();
        QCOMPARE(m_change->failure().problem, ChangeProblem::Disconnected);
        QCOMPARE(m_ended->count(), 1);
        QVERIFY(!m_change->canGoBack());
        QVERIFY(!m_change->canSearch());
    }

    void aSensorInItsMenuAfterTheResetIsWaitedFor()
    {
        m_device->setOnRequest([this](const ports::Request& request) {
            if (!request.write.isEmpty() &&
                request.write.first().item == ItemId::ResettingCommunicationSettings) {
                moveDevice(urlOf(wanted, 7));
                m_device->failOpenings(ports::OpenFailure::NotReady);
            }
        });
        QVERIFY(begin(wanted, 7));
        pass(30'000);
        QCOMPARE(m_change->state(), State::Reopening);
        m_device->allowOpenings();
        pass(1'000);
        QCOMPARE(m_change->state(), State::Done);
    }

    void aViewOnlySensorIsNotChanged()
    {
        ConnectionUrl url = urlOf(asDelivered, 3);
        m_links->place(url);
        url.viewOnly = true;
        sensor::SensorSession* viewed = m_workspace->add(url);
        viewed->open();
        support::settle();
        CommunicationChange change(*viewed, *m_workspace, *m_links, m_scheduler);
        QCOMPARE(change.obstacle(wanted, 9), ChangeProblem::NotPossibleNow);
        QVERIFY(!change.start(wanted, 9));
    }
};

QTEST_GUILESS_MAIN(CommunicationChangeTest)
#include "tst_communication_change.moc"
