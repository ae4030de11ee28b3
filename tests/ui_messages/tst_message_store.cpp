#include "frames.h"
#include "message_filter.h"
#include "message_store.h"

#include <QtTest>

using namespace lds::ui;
using lds::ports::FrameMeaning;

class MessageStoreTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void pollsReadNothingButTheMeasurement()
    {
        QVERIFY(isPoll(poll()));
        QVERIFY(isPoll(pollAnswer()));
        QVERIFY(isPoll(read(400017, 400018)));
        QVERIFY(!isPoll(read(400101, 400171)));
        QVERIFY(!isPoll(read(400001, 400022)));
        QVERIFY(!isPoll(read(400011, 400101)));
        QVERIFY(!isPoll(frame(FrameMeaning::Write, {QStringLiteral("400011"), QStringLiteral("400011")})));
        QVERIFY(!isPoll(frame(FrameMeaning::Read)));
        QVERIFY(!isPoll(refused()));
    }

    void aFloodOfPollsDoesNotPushOutTheWrite()
    {
        MessageStore store({100, 100, 1 << 24, 1 << 24});
        const auto write =
            store.append(frame(FrameMeaning::Write, {QStringLiteral("400101"), QStringLiteral("400102")}));
        for (int i = 0; i < 10'000; ++i) {
            store.append(poll());
            store.trim();
        }
        QVERIFY(store.contains(write));
        QCOMPARE(store.frame(write).meaning, FrameMeaning::Write);
        QVERIFY(store.size() <= 101);
        QVERIFY(store.size() >= 90);
        QCOMPARE(qulonglong(store.size()) + store.trimmed(), 10'001);
    }

    void messagesAreBoundInNumberAndInBytes()
    {
        MessageStore byNumber({50, 50, 1 << 24, 1 << 24});
        MessageStore byBytes({1'000'000, 50, 20'000, 20'000});
        for (int i = 0; i < 1000; ++i) {
            byNumber.append(read(400101, 400171));
            byNumber.trim();
            QVERIFY(byNumber.size() <= 50);
            byBytes.append(read(400101, 400171));
            byBytes.trim();
            QVERIFY(byBytes.bytes() <= 20'000);
        }
        QVERIFY(byBytes.size() > 10);
    }

    void keysStandInOrderOfArrivalAcrossBothRings()
    {
        MessageStore store;
        QList<MessageStore::Key> expected;
        for (int i = 0; i < 30; ++i)
            expected.append(store.append(i % 3 == 0 ? read(400101, 400101) : poll()));
        QCOMPARE(store.keys(), expected);
        QCOMPARE(store.takeAll().size(), 30);
        QCOMPARE(store.size(), 0);
        QCOMPARE(store.bytes(), 0);
        QVERIFY(!store.contains(expected.first()));
    }
};

QTEST_GUILESS_MAIN(MessageStoreTest)
#include "tst_message_store.moc"
