#include "session_fixture.h"

using namespace lds::sensor;
using lds::ports::FailureCode;
using lds::ports::LinkState;
using lds::ports::OpenFailure;
using lds::support::settle;

class SessionConnectionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void openingReadsEverythingReadableAndThenPolls()
    {
        SessionFixture f;
        QVERIFY(!f.session->reaches(ItemId::Span));
        QVERIFY(!f.session->held(ItemId::Span));
        f.session->open();
        QCOMPARE(f.session->connection(), Connection::Opening);
        settle();
        QCOMPARE(f.session->connection(), Connection::Ready);
        QCOMPARE(f.sensor().reads(), 1);
        QCOMPARE(f.sensor().writes(), 0);
        int readable = 0;
        for (const auto& item : f.session->catalog().items()) {
            if (!item.isReadable() || !item.modbus)
                continue;
            ++readable;
            QCOMPARE(f.session->held(item.id), std::optional(f.sensor().value(item.id)));
            QVERIFY(f.session->readAtNs(item.id) > 0);
        }
        QCOMPARE(readable, f.sensor().requests().first().items.size());
        QCOMPARE(f.sensor().pollIntervalMs(), 10);
        QVERIFY(!f.session->held(ItemId::SetValueSaving)); // cannot be read
        QVERIFY(f.session->reaches(ItemId::SetValueSaving));
        QVERIFY(!f.session->reaches(ItemId::MacAddress));
        QCOMPARE(f.session->saved(), Saved::Unknown);
        QVERIFY(f.session->canWrite());
    }

    void aFailureToOpenIsToldAndTriedAgainMoreAndMoreSlowly()
    {
        SessionFixture f;
        f.sensor().failOpenings(OpenFailure::Refused, QStringLiteral("Connection refused"));
        f.session->open();
        settle();
        QCOMPARE(f.session->connection(), Connection::Reconnecting);
        QCOMPARE(f.session->linkReport().failure, OpenFailure::Refused);
        QCOMPARE(f.session->linkReport().detail, QStringLiteral("Connection refused"));
        QList<int> gaps;
        int gap = 0;
        int openings = f.sensor().openings();
        while (gaps.size() < 6) {
            f.pass(10);
            gap += 10;
            if (std::exchange(openings, f.sensor().openings()) != f.sensor().openings()) {
                gaps.append(gap);
                gap = 0;
                QCOMPARE(f.session->linkReport().failure, OpenFailure::Refused);
            }
        }
        QCOMPARE(gaps, (QList<int>{500, 1000, 2000, 4000, 8000, 8000}));
        f.sensor().allowOpenings();
        f.pass(8000);
        QVERIFY(f.session->isReady());
        QCOMPARE(f.session->linkReport().failure, OpenFailure::None);
    }

    void aPersonCanTryAtOnce()
    {
        SessionFixture f;
        f.sensor().failOpenings(OpenFailure::HostNotFound);
        f.session->open();
        settle();
        f.pass(1000);
        QCOMPARE(f.sensor().openings(), 1); // slowly
        f.sensor().allowOpenings();
        f.session->retryNow();
        settle();
        QVERIFY(f.session->isReady());
        f.pass(10'000);
        QCOMPARE(f.sensor().openings(), 2); // and the try that was due has been given up
    }

    void aSensorInItsMenuIsAskedUntilItLeavesIt()
    {
        SessionFixture f;
        f.sensor().setNotReady(true);
        f.session->open();
        settle();
        QVERIFY(f.session->isSensorNotReady());
        QCOMPARE(f.session->linkReport().failure, OpenFailure::NotReady);
        f.pass(20'000);
        QVERIFY(f.session->isSensorNotReady());
        f.sensor().setNotReady(false);
        f.pass(500);
        QVERIFY(f.session->isReady());
        QVERIFY(!f.session->isSensorNotReady());
    }

    void aMenuEnteredBetweenOpeningAndReadingIsWaitedFor()
    {
        SessionFixture f;
        f.sensor().refuseReads(FailureCode::NotReady);
        f.session->open();
        settle();
        QCOMPARE(f.session->connection(), Connection::Reading);
        QVERIFY(f.session->isSensorNotReady());
        f.sensor().refuseReads(FailureCode::None);
        f.pass(500);
        QVERIFY(f.session->isReady());
    }

    void aFirstReadingWithoutAnswerIsReadAgain()
    {
        SessionFixture f;
        f.sensor().loseReads(1);
        f.session->open();
        settle();
        f.sensor().timeOut();
        settle();
        QCOMPARE(f.session->connection(), Connection::Reading);
        f.pass(500);
        QVERIFY(f.session->isReady());
    }

    void whatRefusesToBeReadIsNoSensor()
    {
        SessionFixture f;
        f.sensor().refuseReads(FailureCode::AddressRefused);
        f.session->open();
        settle();
        QCOMPARE(f.session->connection(), Connection::Reconnecting);
        QCOMPARE(f.session->linkReport().failure, OpenFailure::NotASensor);
        QVERIFY(!f.session->isSensorNotReady());
        f.pass(7000);
        QCOMPARE(f.sensor().reads(), 1); // slowly
        f.pass(1000);
        QCOMPARE(f.sensor().reads(), 2);
        f.sensor().refuseReads(FailureCode::None);
        f.session->retryNow();
        settle();
        QVERIFY(f.session->isReady());
        QCOMPARE(f.session->linkReport().failure, OpenFailure::None);
        QCOMPARE(f.session->linkReport().state, LinkState::Open);
    }

    void pollsRefusedShowTheMenuAndPollsAnsweredEndIt()
    {
        SessionFixture f;
        f.openReady();
        QSignalSpy readiness(f.session.get(), &SensorSession::readinessChanged);
        f.sensor().refusePoll(FailureCode::NotReady);
        settle();
        QVERIFY(f.session->isSensorNotReady());
        QVERIFY(!f.session->canWrite());
        QVERIFY(!f.session->apply());
        QVERIFY(!f.session->run(ItemId::LaserStop, 1));
        QCOMPARE(f.session->connection(), Connection::Ready);
        f.sensor().refusePoll(FailureCode::None);
        settle();
        QVERIFY(!f.session->isSensorNotReady());
        QVERIFY(f.session->canWrite());
        QCOMPARE(readiness.count(), 2);
    }

    void measurementsArriveAndGoStaleWithTheConnection()
    {
        SessionFixture f;
        f.openReady();
        QVERIFY(!f.session->latest());
        QSignalSpy measured(f.session.get(), &SensorSession::measured);
        for (int i = 0; i < 150; ++i) {
            f.scheduler.advanceMs(10);
            f.sensor().emitMeasurement(f.sample(i));
            settle();
        }
        QCOMPARE(measured.count(), 150);
        QVERIFY(f.session->latest());
        QCOMPARE(f.session->latest()->value, 149);
        QCOMPARE(f.session->trend().size(), std::size_t(150));
        QCOMPARE(f.session->measurementRate(), 100.0);
        QCOMPARE(f.session->pollStatistics().answered, quint64(150));
        f.sensor().cut();
        settle();
        QVERIFY(!f.session->latest());
        QVERIFY(f.session->isStale());
        QCOMPARE(f.session->measurementRate(), 0.0);
        QCOMPARE(f.session->trend().size(), std::size_t(150));
        QVERIFY(f.session->held(ItemId::Span)); // the last known ones, marked stale
        f.session->clearTrend();
        QVERIFY(f.session->trend().isEmpty());
    }

    void reconnectingKeepsEditsReadsAgainAndWritesNothing()
    {
        SessionFixture f;
        f.openReady();
        f.edit(ItemId::HighSetValue, 20000);
        f.edit(ItemId::DisplayInversion, 1);
        f.runAndSettle(ItemId::SetValueSaving, 0);
        QCOMPARE(f.session->saved(), Saved::Saved);
        f.sensor().forgetRequests();
        f.sensor().cut();
        settle();
        QCOMPARE(f.session->connection(), Connection::Reconnecting);
        QCOMPARE(f.session->linkReport().failure, OpenFailure::Lost);
        QVERIFY(!f.session->canWrite());
        f.sensor().set(ItemId::HighSetValue, 15000); // a PLC, meanwhile
        f.pass(500);
        QVERIFY(f.session->isReady());
        QCOMPARE(f.sensor().writes(), 0);
        QCOMPARE(f.wanted(ItemId::HighSetValue), 20000);
        QCOMPARE(f.wanted(ItemId::DisplayInversion), 1);
        QVERIFY(f.session->pending().find(ItemId::HighSetValue)->conflict);
        QVERIFY(!f.session->pending().find(ItemId::DisplayInversion)->conflict);
        QCOMPARE(f.conflicts, QList{ItemId::HighSetValue});
        QCOMPARE(f.external.size(), 1);
        QCOMPARE(f.external.first().before, f.session->pending().find(ItemId::HighSetValue)->base);
        QCOMPARE(f.session->saved(), Saved::Unknown);
        f.passWalk();
        QCOMPARE(f.sensor().writes(), 0);
    }

    /// Whoever pulled the cable may have switched the sensor off as well.
    void afterACutNobodyCanTellWhetherItIsSaved()
    {
        SessionFixture f;
        f.openReady();
        f.runAndSettle(ItemId::SetValueSaving, 0);
        f.sensor().cut();
        settle();
        f.pass(500);
        QVERIFY(f.session->isReady());
        QVERIFY(f.external.isEmpty());
        QCOMPARE(f.session->saved(), Saved::Unknown);
    }

    void closingEndsThePollsAndKeepsTheEdits()
    {
        SessionFixture f;
        f.openReady();
        f.edit(ItemId::DisplayInversion, 1);
        f.session->close();
        settle();
        QCOMPARE(f.session->connection(), Connection::Closed);
        QVERIFY(!f.sensor().isOpen());
        QCOMPARE(f.wanted(ItemId::DisplayInversion), 1);
        const int asked = int(f.sensor().requests().size());
        f.passWalk();
        QCOMPARE(f.sensor().requests().size(), asked);
        QCOMPARE(f.sensor().openings(), 1);
        f.session->open();
        settle();
        QVERIFY(f.session->isReady());
        QCOMPARE(f.sensor().writes(), 0);
    }

    void closingAndOpeningInOneBreathDoesNotMixThemUp()
    {
        SessionFixture f;
        f.session->open();
        f.session->close();
        f.session->open();
        settle();
        QVERIFY(f.session->isReady());
        f.session->close();
        f.session->open();
        f.session->close();
        settle();
        QCOMPARE(f.session->connection(), Connection::Closed);
        QVERIFY(!f.sensor().isOpen());
    }

    void anAnswerToNoQuestionIsDropped()
    {
        SessionFixture f;
        f.openReady();
        const auto held = f.session->heldValues();
        f.sensor().answerLate(1, {{ItemId::Span, 12345}}); // once was the first reading's
        f.sensor().answerLate(987654, {{ItemId::Span, 12345}});
        settle();
        QCOMPARE(f.session->heldValues(), held);
    }

    void theTypeIsGuessedFromWhatIsRead()
    {
        SessionFixture f(false, std::nullopt);
        QCOMPARE(f.session->modelsThatFit(), lds::catalog::everyModel);
        QVERIFY(!f.session->modelIsStated());
        f.sensor().set(ItemId::HighSetValue, 900'000); // beyond the 30 mm type
        f.sensor().set(ItemId::DisplayDigit, 1);
        f.session->open();
        settle();
        QVERIFY(f.session->isReady());
        QCOMPARE(f.session->model(), lds::catalog::SensorModel::HlG205);
        QVERIFY(!f.session->modelContradicted());
        f.session->setModel(lds::catalog::SensorModel::HlG203);
        QVERIFY(f.session->modelIsStated());
        QVERIFY(f.session->modelContradicted());
        f.session->setModel(lds::catalog::SensorModel::HlG212);
        QVERIFY(!f.session->modelContradicted());
    }

    void editsThatAreNotLegalForACorrectedTypeStayAndAreNamed()
    {
        SessionFixture f(false, lds::catalog::SensorModel::HlG205);
        f.openReady();
        f.edit(ItemId::Offset, 900'000);
        QVERIFY(f.session->problems().isEmpty());
        QSignalSpy identity(f.session.get(), &SensorSession::identityChanged);
        f.session->setModel(lds::catalog::SensorModel::HlG203);
        QCOMPARE(identity.count(), 1);
        QCOMPARE(f.wanted(ItemId::Offset), 900'000);
        QCOMPARE(f.session->problems().size(), 1);
        QCOMPARE(f.session->problems().first().items.first(), ItemId::Offset);
        QVERIFY(!f.session->plan());
    }

    void theSessionMayBeDeletedInAnyOfItsSignals()
    {
        using Signal = void (SensorSession::*)();
        for (const Signal signal :
             {&SensorSession::connectionChanged, &SensorSession::busyChanged, &SensorSession::measured}) {
            SessionFixture f;
            connect(f.session.get(), signal, this, [&f] { f.session.reset(); });
            f.session->open();
            settle();
            if (f.session)
                f.sensor().emitMeasurement(f.sample(1));
            settle();
            QVERIFY(!f.session);
        }
        SessionFixture f;
        connect(f.session.get(), &SensorSession::heldChanged, this, [&f] { f.session.reset(); });
        f.session->open();
        settle();
        QVERIFY(!f.session);
    }
};

QTEST_GUILESS_MAIN(SessionConnectionTest)
#include "tst_session_connection.moc"
