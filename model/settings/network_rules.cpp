#include "judgement.h"

#include <array>

namespace lds::settings {

namespace {

using catalog::WriteGroup;

constexpr std::array addressOctets{ItemId::IpAddress1stOctet, ItemId::IpAddress2ndOctet,
                                   ItemId::IpAddress3rdOctet, ItemId::IpAddress4thOctet};
constexpr std::array maskOctets{ItemId::SubnetMask1stOctet, ItemId::SubnetMask2ndOctet,
                                ItemId::SubnetMask3rdOctet, ItemId::SubnetMask4thOctet};
constexpr std::array gatewayOctets{ItemId::DefaultGateway1stOctet, ItemId::DefaultGateway2ndOctet,
                                   ItemId::DefaultGateway3rdOctet, ItemId::DefaultGateway4thOctet};

constexpr quint32 noGateway = 0; ///< 0.0.0.0 stands for none (§5.1.1)

std::optional<quint32> addressIn(const Values& state, WriteGroup group)
{
    quint32 address = 0;
    for (const ItemId octet : octetsOf(group)) {
        const std::optional<Value> value = known(state, octet);
        if (!value)
            return std::nullopt;
        address = (address << 8) | (quint32(*value) & 0xff);
    }
    return address;
}

bool isFirstOctetAllowed(quint32 address)
{
    const quint32 first = address >> 24;
    return first != 0 && first != 127 && first < 224;
}

/// Ones, then zeros: the complement plus one is a power of two. All ones and all zeros pass.
bool isContiguous(quint32 mask)
{
    const quint32 hostPart = ~mask;
    return (hostPart & (hostPart + 1)) == 0;
}

/// With a mask of 31 or 32 bits no address passes: what remains is always all zeros or all ones.
bool areHostBitsAllowed(quint32 address, quint32 mask)
{
    const quint32 host = address & ~mask;
    return host != 0 && host != ~mask;
}

/// The three groups of a state and who of them is being judged.
class NetworkJudgement {
public:
    NetworkJudgement(const Values& state, const Subjects& subjects)
        : m_subjects(subjects)
        , m_address(addressIn(state, WriteGroup::IpAddress))
        , m_mask(addressIn(state, WriteGroup::SubnetMask))
        , m_gateway(addressIn(state, WriteGroup::DefaultGateway))
    {}

    QList<Refusal> refusals()
    {
        judgeAddress();
        judgeMask();
        judgeAddressInMask();
        judgeGateway();
        judgeGatewayInMask();
        judgeGatewayAndAddress();
        return m_refusals;
    }

private:
    bool isAbout(std::initializer_list<WriteGroup> groups) const
    {
        return std::any_of(groups.begin(), groups.end(),
                           [&](WriteGroup group) { return m_subjects.hasAny(octetsOf(group)); });
    }

    void refuse(Rule rule, std::initializer_list<WriteGroup> groups)
    {
        QList<ItemId> items;
        for (const WriteGroup group : groups) {
            for (const ItemId octet : octetsOf(group))
                items << octet;
        }
        m_refusals << m_subjects.refusal(rule, items);
    }

    void judgeAddress()
    {
        if (isAbout({WriteGroup::IpAddress}) && m_address && !isFirstOctetAllowed(*m_address))
            m_refusals << m_subjects.refusal(Rule::AddressFirstOctet, {ItemId::IpAddress1stOctet});
    }

    void judgeMask()
    {
        if (isAbout({WriteGroup::SubnetMask}) && m_mask && !isContiguous(*m_mask))
            refuse(Rule::MaskNotContiguous, {WriteGroup::SubnetMask});
    }

    void judgeAddressInMask()
    {
        if (!isAbout({WriteGroup::IpAddress, WriteGroup::SubnetMask}) || !m_address || !m_mask)
            return;
        if (!areHostBitsAllowed(*m_address, *m_mask))
            refuse(Rule::AddressHostBits, {WriteGroup::IpAddress, WriteGroup::SubnetMask});
        if ((*m_address & *m_mask) == 0)
            refuse(Rule::AddressNetworkBits, {WriteGroup::IpAddress, WriteGroup::SubnetMask});
    }

    bool hasGateway() const { return m_gateway && *m_gateway != noGateway; }

    void judgeGateway()
    {
        if (isAbout({WriteGroup::DefaultGateway}) && hasGateway() && !isFirstOctetAllowed(*m_gateway))
            m_refusals << m_subjects.refusal(Rule::GatewayFirstOctet, {ItemId::DefaultGateway1stOctet});
    }

    void judgeGatewayInMask()
    {
        if (!isAbout({WriteGroup::DefaultGateway, WriteGroup::SubnetMask}) || !hasGateway() || !m_mask)
            return;
        if (!areHostBitsAllowed(*m_gateway, *m_mask))
            refuse(Rule::GatewayHostBits, {WriteGroup::DefaultGateway, WriteGroup::SubnetMask});
    }

    void judgeGatewayAndAddress()
    {
        if (!isAbout({WriteGroup::DefaultGateway, WriteGroup::IpAddress, WriteGroup::SubnetMask}) ||
            !hasGateway() || !m_address || !m_mask)
            return;
        if ((*m_gateway & *m_mask) != (*m_address & *m_mask))
            refuse(Rule::GatewayOtherNetwork,
                   {WriteGroup::DefaultGateway, WriteGroup::IpAddress, WriteGroup::SubnetMask});
    }

    const Subjects& m_subjects;
    std::optional<quint32> m_address;
    std::optional<quint32> m_mask;
    std::optional<quint32> m_gateway;
    QList<Refusal> m_refusals;
};

} // namespace

std::span<const ItemId> octetsOf(WriteGroup group)
{
    switch (group) {
    case WriteGroup::IpAddress:
        return addressOctets;
    case WriteGroup::SubnetMask:
        return maskOctets;
    case WriteGroup::DefaultGateway:
        return gatewayOctets;
    case WriteGroup::None:
        break;
    }
    return {};
}

QList<Refusal> judgeNetwork(const Values& state, const Subjects& subjects)
{
    return NetworkJudgement(state, subjects).refusals();
}

} // namespace lds::settings
