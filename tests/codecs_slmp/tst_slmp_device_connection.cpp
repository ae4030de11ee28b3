#include "golden_checks.h"
#include "slmp_device_info_compare.h"
#include "slmp_ip_address_set.h"
#include "slmp_node_search.h"

#include <QTest>

using namespace lds::slmp;
using golden::hex;

namespace {

const ClientAddress client{{{1, 2, 3, 4, 5, 6}}, 0xc0a8010a};
const ClientAddress otherClient{{{1, 2, 3, 4, 5, 7}}, 0xc0a8010a};

NodeSearchResponse found()
{
    NodeSearchResponse response;
    response.client = client;
    response.mac = golden::sensor.mac;
    response.ip = 0xc0a80106;
    response.subnetMask = 0xffffff00;
    response.defaultGateway = 0xc0a80101;
    response.hostName = QByteArrayLiteral("line");
    response.vendorCode = hlg2VendorCode;
    response.modelCode = hlg2ModelCode;
    response.version = 0x0102;
    return response;
}

IpAddressSetRequest setting()
{
    return {client, golden::sensor.mac, 0xc0a80114, 0xffffff00, 0xc0a80101, QByteArrayLiteral("line")};
}

int judgedWith(QByteArray data, qsizetype index, int value)
{
    data[index] = char(value);
    return golden::judged({Command::IpAddressSet, 0, data});
}

} // namespace

class SlmpDeviceConnectionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nodeSearch_data() { golden::addRows({"node-search"}); }
    void nodeSearch();
    void ipAddressSet_data() { golden::addRows({"ip-address-set"}); }
    void ipAddressSet();
    void deviceInfoCompare_data() { golden::addRows({"device-info-compare"}); }
    void deviceInfoCompare();

    void nodeSearchGetsNoAnswerForOtherAddressFamilies();
    void malformedSearchesGetTheirCode();
    void findingsForOtherClientsAreNotTaken();
    void findingsOfAnyHostNameAreBoundedByTheMessage();
    void malformedFindingsAreRefused();
    void onlyTheSensorNamedAnswersIpAddressSet();
    void ipAddressSetRefusesOtherAddressFamilies();
    void hostNamesEndAt32Bytes();
    void onlyUdpCanBeSet();
    void malformedIpAddressSetsGetTheirCode();
    void settingsForOtherClientsAreNotTaken();
    void comparingNamesWhatDiffers_data();
    void comparingNamesWhatDiffers();
    void malformedComparisonsAreRefused();
};

void SlmpDeviceConnectionTest::nodeSearch()
{
    const NodeSearchRequest request{client};
    golden::checkBothDirections(golden::fetched(), request, encodeResponse(found()));
    QVERIFY(decodeNodeSearchResponse(request, encodeResponse(found())) == found());
}

void SlmpDeviceConnectionTest::ipAddressSet()
{
    const IpAddressSetResponse response{client.mac};
    golden::checkBothDirections(golden::fetched(), setting(), encodeResponse(response));
    QVERIFY(decodeIpAddressSetResponse(setting(), encodeResponse(response)) == response);
}

void SlmpDeviceConnectionTest::deviceInfoCompare()
{
    const DeviceInfoCompareRequest request{compareEverything, {0x0109, 0x02000008, 0x0100}};
    const auto response = compare(request, {hlg2VendorCode, hlg2ModelCode, 0x0102});
    golden::checkBothDirections(golden::fetched(), request, encodeResponse(response));
    QVERIFY(decodeDeviceInfoCompareResponse(request, encodeResponse(response)) == response);
}

// §5.4.3 notes: no response to an IPv6 address.
void SlmpDeviceConnectionTest::nodeSearchGetsNoAnswerForOtherAddressFamilies()
{
    const auto judged = [](const char* data) { return golden::judged({Command::NodeSearch, 0, hex(data)}); };
    QCOMPARE(judged("060504030201 04 0a01a8c0"), golden::accepts);
    QCOMPARE(judged("060504030201 10 000102030405060708090a0b0c0d0e0f"), golden::silent);
    QCOMPARE(judged("060504030201 00"), golden::silent);
    QCOMPARE(judged("060504030201 05 0a01a8c000"), golden::silent);
}

void SlmpDeviceConnectionTest::malformedSearchesGetTheirCode()
{
    const QByteArray good = hex("060504030201 04 0a01a8c0");
    QCOMPARE(golden::judged({Command::NodeSearch, 1, good}), int(CompleteCode::Command));
    QCOMPARE(golden::judged({Command::NodeSearch, 0, {}}), int(CompleteCode::RequestDataSize));
    QCOMPARE(golden::judged({Command::NodeSearch, 0, good.chopped(1)}), int(CompleteCode::RequestDataSize));
    QCOMPARE(golden::judged({Command::NodeSearch, 0, good + 'x'}), int(CompleteCode::RequestDataSize));
}

void SlmpDeviceConnectionTest::findingsForOtherClientsAreNotTaken()
{
    for (const ClientAddress& asker : {otherClient, ClientAddress{client.mac, 0xc0a8010b}}) {
        const auto response = decodeNodeSearchResponse({asker}, encodeResponse(found()));
        QVERIFY(!response);
        QCOMPARE(response.error().error, ResponseError::AnotherAnswer);
    }
}

void SlmpDeviceConnectionTest::findingsOfAnyHostNameAreBoundedByTheMessage()
{
    for (const int size : {0, 1, 32, 33, 255, 256}) {
        NodeSearchResponse response = found();
        response.hostName = QByteArray(size, 'h');
        const auto decoded = decodeNodeSearchResponse({client}, encodeResponse(response));
        QVERIFY(decoded.has_value());
        QCOMPARE(decoded->hostName, QByteArray(qMin(size, 255), 'h')); // one byte holds the length
        QCOMPARE(int(decoded->port), 45237);
    }
    QByteArray lies = encodeResponse(found());
    lies[30] = char(255); // a host name beyond the end
    QCOMPARE(decodeNodeSearchResponse({client}, lies).error().error, ResponseError::Data);
}

void SlmpDeviceConnectionTest::malformedFindingsAreRefused()
{
    const QByteArray good = encodeResponse(found());
    const auto isRefused = [](const QByteArray& data) {
        const auto response = decodeNodeSearchResponse({client}, data);
        return !response && response.error().error == ResponseError::Data;
    };
    QVERIFY(isRefused(good + 'x'));
    for (qsizetype size = 0; size < good.size(); ++size)
        QVERIFY(isRefused(good.left(size)));
    for (const int index : {6, 17, 43}) { // the three address sizes; the host name has four bytes
        QByteArray other = good;
        QCOMPARE(int(other.at(index)), 4);
        other[index] = 16;
        QVERIFY(isRefused(other));
    }
}

void SlmpDeviceConnectionTest::onlyTheSensorNamedAnswersIpAddressSet()
{
    IpAddressSetRequest request = setting();
    request.mac.octets.back() ^= 1;
    QCOMPARE(golden::judged(encodeRequest(setting())), golden::accepts);
    QCOMPARE(golden::judged(encodeRequest(request)), golden::silent);
    // Nor is a refusal anybody else's business.
    request.protocol = 2;
    QCOMPARE(golden::judged(encodeRequest(request)), golden::silent);
    const Message cut{Command::IpAddressSet, 0, encodeRequest(request).data.left(25)};
    QCOMPARE(golden::judged(cut), golden::silent);
    const QByteArray ipv6 = hex("060504030201 10") + QByteArray(16, '\1');
    QCOMPARE(golden::judged({Command::IpAddressSet, 0, ipv6 + hex("030201a0f801 10")}), golden::silent);
    QCOMPARE(golden::judged({Command::IpAddressSet, 0, ipv6 + hex("030201a0f800 10")}),
             int(CompleteCode::Request));
}

// §5.4.3 notes: C05CH for an IPv6 address.
void SlmpDeviceConnectionTest::ipAddressSetRefusesOtherAddressFamilies()
{
    const QByteArray good = encodeRequest(setting()).data;
    for (const int index : {6, 17, 35}) {
        QCOMPARE(int(good.at(index)), 4);
        QCOMPARE(judgedWith(good, index, 5), int(CompleteCode::Request));
    }
    QCOMPARE(judgedWith(good, 17, 16), int(CompleteCode::Request));
    QCOMPARE(judgedWith(good, 35, 16), int(CompleteCode::Request));
}

// §5.4.3, complete code 3: the host name exceeds 32 bytes.
void SlmpDeviceConnectionTest::hostNamesEndAt32Bytes()
{
    IpAddressSetRequest request = setting();
    for (const int size : {0, 32}) {
        request.hostName = QByteArray(size, 'h');
        QCOMPARE(golden::judged(encodeRequest(request)), golden::accepts);
    }
    for (const int size : {33, 255}) {
        request.hostName = QByteArray(size, 'h');
        QCOMPARE(golden::judged(encodeRequest(request)), int(CompleteCode::Request));
    }
}

// §5.4.3, complete code 8.
void SlmpDeviceConnectionTest::onlyUdpCanBeSet()
{
    IpAddressSetRequest request = setting();
    for (const int protocol : {0, 2, 255}) {
        request.protocol = quint8(protocol);
        QCOMPARE(golden::judged(encodeRequest(request)), int(CompleteCode::IpSetting));
    }
}

void SlmpDeviceConnectionTest::malformedIpAddressSetsGetTheirCode()
{
    const QByteArray good = encodeRequest(setting()).data;
    QCOMPARE(golden::judged({Command::IpAddressSet, 1, good}), int(CompleteCode::Command));
    QCOMPARE(golden::judged({Command::IpAddressSet, 0, good + 'x'}), int(CompleteCode::RequestDataSize));
    for (qsizetype size = 0; size < good.size(); ++size)
        QCOMPARE(golden::judged({Command::IpAddressSet, 0, good.left(size)}),
                 int(CompleteCode::RequestDataSize));
}

void SlmpDeviceConnectionTest::settingsForOtherClientsAreNotTaken()
{
    const auto failureOf = [](const QByteArray& data) {
        return decodeIpAddressSetResponse(setting(), data).error().error;
    };
    QCOMPARE(failureOf(hex("070504030201")), ResponseError::AnotherAnswer);
    QCOMPARE(failureOf(hex("0605040302")), ResponseError::Data);
    QCOMPARE(failureOf(hex("06050403020100")), ResponseError::Data);
}

void SlmpDeviceConnectionTest::comparingNamesWhatDiffers_data()
{
    QTest::addColumn<int>("targets");
    QTest::addColumn<DeviceInfo>("expected");
    QTest::addColumn<int>("mismatches");
    const quint16 vendor = hlg2VendorCode;
    const quint32 model = hlg2ModelCode;
    QTest::newRow("all the same") << 7 << DeviceInfo{vendor, model, 2} << 0;
    QTest::newRow("vendor") << 7 << DeviceInfo{1, model, 2} << 1;
    QTest::newRow("model") << 7 << DeviceInfo{vendor, 1, 2} << 2;
    QTest::newRow("newer") << 7 << DeviceInfo{vendor, model, 1} << 0x4004;
    QTest::newRow("older") << 7 << DeviceInfo{vendor, model, 3} << 0x8004;
    QTest::newRow("everything") << 7 << DeviceInfo{1, 1, 3} << 0x8007;
    QTest::newRow("only the model asked for") << 2 << DeviceInfo{1, 1, 3} << 2;
    QTest::newRow("only the version asked for") << 4 << DeviceInfo{1, 1, 1} << 0x4004;
    QTest::newRow("nothing asked for") << 0 << DeviceInfo{1, 1, 1} << 0;
}

void SlmpDeviceConnectionTest::comparingNamesWhatDiffers()
{
    QFETCH(int, targets);
    QFETCH(DeviceInfo, expected);
    QFETCH(int, mismatches);
    const DeviceInfoCompareRequest request{quint16(targets), expected};
    const auto response = compare(request, {hlg2VendorCode, hlg2ModelCode, 2});
    QCOMPARE(int(response.targets), targets);
    QCOMPARE(int(response.mismatches), mismatches);
    QVERIFY(decodeDeviceInfoCompareResponse(request, encodeResponse(response)) == response);
}

void SlmpDeviceConnectionTest::malformedComparisonsAreRefused()
{
    const auto judged = [](quint16 subcommand, const char* data) {
        return golden::judged({Command::DeviceInfoCompare, subcommand, hex(data)});
    };
    QCOMPARE(judged(1, "0700 0901 08000002 0001"), int(CompleteCode::Command));
    QCOMPARE(judged(0, "0700 0901 08000002 00"), int(CompleteCode::RequestDataSize));
    QCOMPARE(judged(0, "0700 0901 08000002 0001 00"), int(CompleteCode::RequestDataSize));
    QCOMPARE(judged(0, "0800 0901 08000002 0001"), int(CompleteCode::Request));
    QCOMPARE(judged(0, "0780 0901 08000002 0001"), int(CompleteCode::Request));

    const DeviceInfoCompareRequest request{compareVendor | compareVersion, {}};
    const auto failureOf = [&request](const char* data) {
        const auto response = decodeDeviceInfoCompareResponse(request, hex(data));
        return response ? -1 : int(response.error().error);
    };
    QCOMPARE(failureOf("0500 0500"), -1);
    QCOMPARE(failureOf("0500 0440"), -1);
    QCOMPARE(failureOf("0700 0000"), int(ResponseError::AnotherAnswer));
    for (const char* data : {"0500", "0500 000000", "0500 0200", "0500 0040", "0500 04c0", "0500 0800"})
        QCOMPARE(failureOf(data), int(ResponseError::Data));
}

QTEST_APPLESS_MAIN(SlmpDeviceConnectionTest)
#include "tst_slmp_device_connection.moc"
